#include "static_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

namespace muster {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<std::string_view, std::string_view>, 15> kTypes{{
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".mjs", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".json", "application/json"},
    {".map", "application/json"},
    {".wasm", "application/wasm"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".ico", "image/x-icon"},
    {".glb", "model/gltf-binary"},
    {".woff2", "font/woff2"},
    {".woff", "font/woff"},
    {".txt", "text/plain; charset=utf-8"},
    {".webmanifest", "application/manifest+json"},
}};

}  // namespace

std::string typeOfFile(const std::string& path) {
    const std::string extension = fs::path(path).extension().string();
    for (const auto& [ending, type] : kTypes)
        if (extension == ending) return std::string(type);
    return "application/octet-stream";
}

std::optional<std::string> plainPath(std::string_view target) {
    target = target.substr(0, target.find_first_of("?#"));
    if (target.empty() || target.front() != '/') return std::nullopt;
    for (const char c : target) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           c == '-' || c == '_' || c == '.' || c == '/';
        if (!plain) return std::nullopt;
    }
    if (target.find("/.") != std::string_view::npos || target.find("//") != std::string_view::npos)
        return std::nullopt;
    std::string path(target);
    if (path.back() == '/') path += "index.html";
    return path;
}

std::optional<StaticFile> readStaticFile(const std::string& folder, std::string_view target) {
    const auto plain = plainPath(target);
    if (!plain) return std::nullopt;
    std::error_code error;
    const fs::path root = fs::canonical(folder, error);
    if (error) return std::nullopt;
    const fs::path path = fs::canonical(root / plain->substr(1), error);
    if (error || !fs::is_regular_file(path, error)) return std::nullopt;
    const auto [end, ignored] = std::mismatch(root.begin(), root.end(), path.begin(), path.end());
    if (end != root.end()) return std::nullopt;
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return std::nullopt;
    StaticFile file;
    file.body.assign(std::istreambuf_iterator<char>(stream), {});
    file.type = typeOfFile(path.string());
    // File names below /assets contain a hash of the contents.
    const bool hashed = plain->rfind("/assets/", 0) == 0;
    file.cache = hashed ? kKeptForever : "no-cache";
    return file;
}

}  // namespace muster
