// Requests to the shelf of takes and to exports (docs/protocol.md, "Takes over HTTP").
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace muster {

/// What a path of the shelf asks for.
enum class ShelfAction : std::uint8_t {
    List,
    Put,
    Download,
    Edit,
    Remove,
    Open,
    Restore,
    ShowPicture,
    PutPicture,
    BeginExport,
    ShowExport,
    CancelExport,
    DownloadExport,
};

/// A request to the shelf.
struct ShelfRequest {
    ShelfAction action = ShelfAction::List;
    std::string name;                ///< Of the take, or number of the export; empty for none.
    std::vector<std::uint8_t> body;  ///< Empty for most.
    std::uint32_t director = 0;      ///< Who opens it, as Welcome calls them; 0 for somebody.
};

/// True where a target belongs to the shelf.
bool isShelfTarget(std::string_view target);
/// The action of a method and a target; nothing for a pair that has none.
std::optional<ShelfRequest> shelfRequest(std::string_view method, std::string_view target);
/// True for actions that change nothing.
bool isReading(ShelfAction action);
/// The most bytes of an action's body; 0 for none.
std::size_t mostBodyBytes(ShelfAction action, std::size_t takeBytes);

}  // namespace muster
