#include "shelf_request.h"

#include <array>

#include "request_target.h"

namespace muster {
namespace {

constexpr std::size_t kMostTextBytes = std::size_t{16} << 10;
constexpr std::size_t kMostPictureBytes = std::size_t{512} << 10;

/// A kind of request: a method, the folder and what follows the name.
struct Route {
    std::string_view method;
    std::string_view folder;
    bool named;
    std::string_view rest;
    ShelfAction action;
};

constexpr std::array kRoutes{
    Route{"GET", "/takes", false, "", ShelfAction::List},
    Route{"POST", "/takes", false, "", ShelfAction::Put},
    Route{"GET", "/takes", true, "", ShelfAction::Download},
    Route{"PATCH", "/takes", true, "", ShelfAction::Edit},
    Route{"DELETE", "/takes", true, "", ShelfAction::Remove},
    Route{"POST", "/takes", true, "/open", ShelfAction::Open},
    Route{"POST", "/takes", true, "/restore", ShelfAction::Restore},
    Route{"GET", "/takes", true, "/picture", ShelfAction::ShowPicture},
    Route{"PUT", "/takes", true, "/picture", ShelfAction::PutPicture},
    Route{"POST", "/exports", false, "", ShelfAction::BeginExport},
    Route{"GET", "/exports", true, "", ShelfAction::ShowExport},
    Route{"DELETE", "/exports", true, "", ShelfAction::CancelExport},
    Route{"GET", "/exports", true, "/file", ShelfAction::DownloadExport},
};

bool below(std::string_view target, std::string_view folder) {
    return target.substr(0, folder.size()) == folder &&
           (target.size() == folder.size() || target[folder.size()] == '/');
}

}  // namespace

bool isShelfTarget(std::string_view target) {
    target = withoutQuery(target);
    return below(target, "/takes") || below(target, "/exports");
}

std::optional<ShelfRequest> shelfRequest(std::string_view method, std::string_view target) {
    const auto director = queryDirector(target);
    target = withoutQuery(target);
    for (const Route& route : kRoutes) {
        if (method != route.method || !below(target, route.folder)) continue;
        std::string_view rest = target.substr(route.folder.size());
        std::string_view name;
        if (!rest.empty()) {
            rest.remove_prefix(1);
            name = rest.substr(0, rest.find('/'));
            rest.remove_prefix(name.size());
            if (name.empty()) return std::nullopt;
        }
        if (route.named == name.empty() || rest != route.rest) continue;
        return ShelfRequest{.action = route.action, .name = std::string(name), .director = director};
    }
    return std::nullopt;
}

bool isReading(ShelfAction action) {
    return action == ShelfAction::List || action == ShelfAction::Download ||
           action == ShelfAction::ShowPicture || action == ShelfAction::ShowExport ||
           action == ShelfAction::DownloadExport;
}

std::size_t mostBodyBytes(ShelfAction action, std::size_t takeBytes) {
    switch (action) {
        case ShelfAction::Put:
            return takeBytes;
        case ShelfAction::PutPicture:
            return kMostPictureBytes;
        case ShelfAction::Edit:
        case ShelfAction::BeginExport:
            return kMostTextBytes;
        default:
            return 0;
    }
}

}  // namespace muster
