// The ids that commands have, for histories: these know things by names of their own.
import { commands, definitionOf, definitions } from './read.mjs';
import { kBanner } from './cpp.mjs';

/** What has ids of its own, by the type of these. */
const kSubjects = { GroupId: 'Group', CharacterId: 'Character', OrderId: 'Order', AreaId: 'Area' };
const kNumbers = ['CharacterId', 'OrderId'];

const hasIds = ({ type }) => type in kSubjects || (definitionOf(type)?.fields.some(hasIds) ?? false);

/** The line that visits the ids of one field. */
function visit({ name, type, isList, isOptional }) {
  const one = (value) => (type in kSubjects ? `visit(SubjectKind::${kSubjects[type]}, ${value}${kNumbers.includes(type) ? '' : '.value'})` : `visitIds(${value}, visit)`);
  if (isList) return `    for (auto& one : c.${name}) ${one('one')};`;
  return isOptional && !(type in kSubjects) ? `    if (c.${name}) ${one(`*c.${name}`)};` : `    ${one(`c.${name}`)};`;
}

const visitor = (cpp, fields) => {
  const lines = fields.filter(hasIds).map(visit);
  if (lines.length === 0) return `template <class Visit>\nvoid visitIds(${cpp}&, const Visit&) {}`;
  return `template <class Visit>\nvoid visitIds(${cpp}& c, const Visit& visit) {\n${lines.join('\n')}\n}`;
};

const header = () => `${kBanner}// Calls \`visit(kind, id)\` for each id of a command. PutThing and RemoveThing tell what their \`id\` is of.
#pragma once

#include "muster/command.h"
#include "studio/session/history/names.h"

namespace muster {

${definitions.filter(({ fields }) => fields.some(hasIds) && !fields.some(({ name }) => name === 'box')).map(({ cpp, fields }) => visitor(cpp, fields)).join('\n')}
${commands.map(({ name, fields }) => visitor(name, fields)).join('\n')}

}  // namespace muster
`;

export const idFiles = () => ({ 'src/studio/session/history/generated/command_ids.h': header() });
