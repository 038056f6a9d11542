// The structs of api/*.txt that are written for C++ too: what is read of worlds. And how they become those of C.
import { apiSections, apiStructs } from './api.mjs';
import { isFlat, marshalled, sameLayout, versionLine } from './c_struct.mjs';
import { structLines } from './cpp_struct.mjs';

const kInclude = 'include/muster/generated';

/** The headers of C++: where they stand, what they are about, and what they include. */
const kFiles = {
  walk_totals: { about: 'Sums over the path costs of many.', uses: [], includes: [] },
  control: {
    about: 'Controls: points of a mesh that fingers move along trajectories (paper sections 4.1 and 4.2).',
    uses: ['cstdint', 'vector'],
    includes: ['generated/enumerations', 'geometry', 'id', 'vec2'],
  },
  event: { about: 'What happened in a step.', uses: ['cstdint'], includes: ['generated/enumerations', 'vec2'] },
  characters: {
    about: 'Read access to the characters of a world, and to the contacts between them.',
    uses: ['cstddef', 'cstdint', 'span'],
    includes: ['generated/enumerations', 'generated/people_definitions', 'ground', 'vec2'],
  },
  views: {
    about: 'Read access to a world except its characters: groups, obstacles, patches, areas.',
    uses: ['cstdint', 'optional', 'span', 'string_view', 'vector'],
    includes: ['generated/control', 'generated/orders_definitions', 'generated/walk_totals', 'ground', 'id', 'vec2'],
  },
  take: {
    about: 'What takes hold, and the outcome of a replay.',
    uses: ['cstddef', 'cstdint', 'string', 'vector'],
    includes: ['event', 'status', 'vec2'],
  },
  figures: {
    folder: 'src/engine/world/generated',
    about: "Figures of runs, in the words of the specification's section 8.",
    uses: ['array', 'cstdint', 'string', 'vector'],
    includes: ['generated/enumerations', 'generated/walk_totals', 'id', 'views'],
  },
};

const includesOf = (names, mark) => (names.length === 0 ? '' : `${names.map(mark).join('\n')}\n\n`);

const struct = (one) => structLines(one, { archived: one.flags.has('archived') ? 'it' : '', isRoomy: true }).join('\n');

function header(name) {
  const { about, uses, includes } = kFiles[name];
  const structs = apiStructs.filter(({ header: own }) => own === name);
  return `// Made by schema/generate.mjs from schema/api/${structs[0].file}.txt: change these, not this file.
// ${about}
#pragma once

${includesOf(uses, (one) => `#include <${one}>`)}${includesOf(includes, (one) => `#include "muster/${one}.h"`)}namespace muster {

${structs.map(struct).join('\n\n')}

}  // namespace muster
`;
}

function marshalling() {
  const written = apiStructs.filter(({ cpp, file }) => cpp && file === 'views');
  const isPlain = ({ name }) => isFlat(name);
  return `// Made by schema/generate.mjs from schema/api/views.txt: change these, not this file.
// What is read of worlds, as structs of C (bindings/c/c_world/marshal.h).
#pragma once

#include <cstddef>

#include "bindings/c/c_world/world_fields.h"
#include "muster/event.h"
#include "muster/muster.h"
#include "muster/views.h"

namespace muster::c_api {

${written.filter(isPlain).map((one) => `static_assert(${sameLayout(one).join(' &&\n              ')});`).join('\n')}

${written.filter((struct) => !isPlain(struct)).map(marshalled).join('\n')}

}  // namespace muster::c_api
`;
}

/** The versions of the structs of a component that callers hand over. */
function versions(component) {
  const structs = apiSections.filter((section) => section.component === component).flatMap(({ declarations }) => declarations.filter(({ version }) => version));
  return `// Made by schema/generate.mjs from schema/api: change these, not this file.
// Versions of structs that callers hand over: a number per kind, and that of its members.
#pragma once

#include "bindings/c/c_world/struct_version.h"
#include "muster/muster.h"

namespace muster::c_api {

${structs.map(versionLine).join('\n')}

}  // namespace muster::c_api
`;
}

const kModules = { core: 'c_world', motion: 'c_motion', io: 'c_io' };

export const viewFiles = () => ({
  ...Object.fromEntries(Object.entries(kModules).map(([component, module]) => [`bindings/c/${module}/generated/struct_versions.h`, versions(component)])),
  ...Object.fromEntries(Object.entries(kFiles).map(([name, { folder = kInclude }]) => [`${folder}/${name}.h`, header(name)])),
  'bindings/c/c_world/generated/view_fields.h': marshalling(),
});
