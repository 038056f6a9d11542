// A small take, as bytes.
#pragma once

#include <doctest.h>

#include <filesystem>
#include <string>

#include "base/text_file.h"
#include "muster/take.h"
#include "muster/world.h"

namespace muster::testing {

/// A take of nine people who stand for so many steps, written to a file that is removed again.
inline std::string madeTake(const std::filesystem::path& folder, int steps,
                            const std::string& name = "Floor") {
    WorldDef def{.name = name, .box = {{-8, -8}, {8, 8}}, .groups = {{.count = 9}}};
    auto world = World::create(def);
    REQUIRE(world.ok());
    std::filesystem::create_directories(folder);
    const std::string path = (folder / "made").string();
    {
        auto writer = TakeWriter::create(path, def);
        REQUIRE(writer.ok());
        for (int i = 0; i < steps; ++i) {
            world->step();
            REQUIRE(writer->observe(*world).ok());
        }
        REQUIRE(writer->finish(*world).ok());
    }
    auto bytes = readTextFile(path);
    REQUIRE(bytes.ok());
    std::filesystem::remove(path);
    return std::move(bytes).value();
}

inline std::span<const std::uint8_t> bytesOf(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace muster::testing
