// Commands in archives: snapshots, takes and hashes.
#pragma once

#include "base/archive.h"
#include "muster/command.h"

namespace muster {

/// Appends the bytes of what a command says: its kind, then its fields.
void encodeBody(Writer& writer, const CommandBody& body);
/// The command by a former name that says the same. None where no or several former commands would, and for
/// things, whose commands have hashes of their own.
std::optional<FormerKinds> formerOf(const CommandBody& body);
/// Reads one back, whatever its values. Fails with ParseError where the bytes are short or the kind is
/// unknown.
Result<CommandBody> decodeBody(Reader& reader);

/// Appends a command's bytes.
void encodeCommand(Writer& writer, const Command& command);
/// Appends what hashes have of it: the bytes of a command by a former name where that says the same, so that
/// states with queued commands have the hashes that they had.
void encodeForHash(Writer& writer, const Command& command);
/// Reads one back. Fails with ParseError where the bytes are short, the kind is unknown or a value is out of
/// its range.
Result<Command> decodeCommand(Reader& reader);

}  // namespace muster
