// Made by schema/generate.mjs from schema/commands.txt: change these, not this file.
// Calls `visit(kind, id)` for each id of a command. PutThing and RemoveThing tell what their `id` is of.
#pragma once

#include "muster/command.h"
#include "studio/session/history/names.h"

namespace muster {

template <class Visit>
void visitIds(Order& c, const Visit& visit) {
    visit(SubjectKind::Group, c.group.value);
    visit(SubjectKind::Character, c.character);
    for (auto& one : c.exits) visit(SubjectKind::Area, one.value);
    visit(SubjectKind::Area, c.area.value);
}
template <class Visit>
void visitIds(QueuedOrder& c, const Visit& visit) {
    visit(SubjectKind::Order, c.id);
    visitIds(c.order, visit);
}
template <class Visit>
void visitIds(GroupDef& c, const Visit& visit) {
    for (auto& one : c.orders) visitIds(one, visit);
}
template <class Visit>
void visitIds(Touch& c, const Visit& visit) {
    visit(SubjectKind::Group, c.group.value);
}
template <class Visit>
void visitIds(AddControl& c, const Visit& visit) {
    visit(SubjectKind::Group, c.group.value);
}
template <class Visit>
void visitIds(EditControl& c, const Visit& visit) {
    visit(SubjectKind::Group, c.group.value);
}
template <class Visit>
void visitIds(ReleaseClient&, const Visit&) {}
template <class Visit>
void visitIds(ChangeGroup& c, const Visit& visit) {
    visit(SubjectKind::Group, c.group.value);
}
template <class Visit>
void visitIds(SetPose& c, const Visit& visit) {
    visit(SubjectKind::Group, c.group.value);
}
template <class Visit>
void visitIds(AddGroup& c, const Visit& visit) {
    visitIds(c.group, visit);
}
template <class Visit>
void visitIds(RemoveGroup& c, const Visit& visit) {
    visit(SubjectKind::Group, c.group.value);
}
template <class Visit>
void visitIds(PutThing& c, const Visit& visit) {
    visit(SubjectKind::Group, c.group.value);
}
template <class Visit>
void visitIds(RemoveThing&, const Visit&) {}
template <class Visit>
void visitIds(SetParameter&, const Visit&) {}
template <class Visit>
void visitIds(GiveOrder& c, const Visit& visit) {
    visit(SubjectKind::Group, c.group.value);
    visitIds(c.order, visit);
}
template <class Visit>
void visitIds(EditQueue& c, const Visit& visit) {
    visit(SubjectKind::Group, c.group.value);
    visit(SubjectKind::Order, c.order);
}
template <class Visit>
void visitIds(AddCharacters& c, const Visit& visit) {
    visit(SubjectKind::Group, c.group.value);
}
template <class Visit>
void visitIds(TransferCharacters& c, const Visit& visit) {
    for (auto& one : c.ids) visit(SubjectKind::Character, one);
    visit(SubjectKind::Group, c.group.value);
}
template <class Visit>
void visitIds(SplitGroup& c, const Visit& visit) {
    visit(SubjectKind::Group, c.group.value);
    for (auto& one : c.ids) visit(SubjectKind::Character, one);
}
template <class Visit>
void visitIds(MergeGroups& c, const Visit& visit) {
    for (auto& one : c.groups) visit(SubjectKind::Group, one.value);
}
template <class Visit>
void visitIds(ChangeCharacters& c, const Visit& visit) {
    for (auto& one : c.ids) visit(SubjectKind::Character, one);
}
template <class Visit>
void visitIds(WriteMotion& c, const Visit& visit) {
    for (auto& one : c.ids) visit(SubjectKind::Character, one);
}
template <class Visit>
void visitIds(ReverseQueue& c, const Visit& visit) {
    visit(SubjectKind::Group, c.group.value);
}

}  // namespace muster
