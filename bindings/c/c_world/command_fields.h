// A command with its body, for both directions (bindings/c/c_world/marshal.h).
#pragma once

#include <utility>

#include "bindings/c/c_world/generated/command_kind_fields.h"

namespace muster::c_api {

/// The body of kind I.
template <std::size_t I, class M>
void bodyFields(M& m, C<M, MusterCommandBody>& c, P<M, CommandBody>& p) {
    if constexpr (M::kReads) p.template emplace<I>();
    const Command named{0, 0, 0, CommandBody(std::in_place_index<I>)};
    m.part(c.*std::get<I>(kCommandMembers), std::get<I>(p), commandName(named));
}
template <class M, std::size_t... I>
void anyBodyFields(M& m, std::size_t kind, C<M, MusterCommandBody>& c, P<M, CommandBody>& p,
                   std::index_sequence<I...>) {
    ((kind == I ? bodyFields<I>(m, c, p) : void()), ...);
}

template <class M>
void fields(M& m, C<M, MusterCommand>& c, P<M, Command>& p) {
    m.template version<MusterCommand>(c.structVersion);
    m.plain(c.step, p.step);
    m.plain(c.client, p.client);
    m.plain(c.sequence, p.sequence);
    if constexpr (M::kReads) {
        if (c.kind < 0 || c.kind >= MUSTER_COMMAND_COUNT)
            return m.fail("kind: found " + std::to_string(c.kind) + ", expected 0 to " +
                          std::to_string(MUSTER_COMMAND_COUNT - 1));
    } else {
        c.kind = static_cast<MusterCommandKind>(p.body.index());
    }
    anyBodyFields(m, static_cast<std::size_t>(c.kind), c.body, p.body,
                  std::make_index_sequence<MUSTER_COMMAND_COUNT>());
}

}  // namespace muster::c_api
