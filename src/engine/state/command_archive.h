// Commands in archives: snapshots, takes and hashes.
#pragma once

#include "base/archive.h"
#include "muster/command.h"

namespace muster {

/// Appends the bytes of what a command says: its kind, then its fields.
void encodeBody(Writer& writer, const CommandBody& body);
/// Reads one back, whatever its values. Fails with ParseError where the bytes are short or the kind is
/// unknown.
Result<CommandBody> decodeBody(Reader& reader);

/// Appends a command's bytes.
void encodeCommand(Writer& writer, const Command& command);
/// Reads one back. Fails with ParseError where the bytes are short, the kind is unknown or a value is out of
/// its range.
Result<Command> decodeCommand(Reader& reader);

}  // namespace muster
