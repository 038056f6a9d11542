// An independent reader of GLB files for tests. It supports only what Muster writes.
#pragma once

#include <doctest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/text_file.h"
#include "muster/quat.h"

namespace muster::testing {

/// A GLB file in memory.
class GltfReader {
public:
    nlohmann::json json;

    explicit GltfReader(const std::string& path) {
        const auto text = readTextFile(path, std::size_t{1} << 30);
        REQUIRE(text.ok());
        const std::string& bytes = *text;
        REQUIRE(bytes.substr(0, 4) == "glTF");
        REQUIRE(word(bytes, 4) == 2);
        REQUIRE(word(bytes, 8) == bytes.size());
        const std::uint32_t length = word(bytes, 12);
        REQUIRE(bytes.substr(16, 4) == "JSON");
        json = nlohmann::json::parse(bytes.substr(20, length));
        REQUIRE(bytes.substr(24 + length, 3) == "BIN");
        buffer_ = bytes.substr(28 + length);
        REQUIRE(buffer_.size() == word(bytes, 20 + length));
        REQUIRE(json["buffers"][0]["byteLength"] == buffer_.size());
    }

    /// Value `k` of an accessor, as real numbers.
    std::vector<double> value(std::size_t accessor, std::size_t k) const {
        const auto& a = json["accessors"][accessor];
        const auto& view = json["bufferViews"][a["bufferView"].get<std::size_t>()];
        const std::size_t parts = partsOf(a["type"]), size = sizeOf(a["componentType"]);
        REQUIRE(k < a["count"].get<std::size_t>());
        const std::size_t at = a.value("byteOffset", std::size_t{0}) + k * parts * size;
        REQUIRE(at + parts * size <= view["byteLength"].get<std::size_t>());
        const char* from = buffer_.data() + view["byteOffset"].get<std::size_t>() + at;
        std::vector<double> values;
        for (std::size_t p = 0; p < parts; ++p) values.push_back(number(from + p * size, a));
        return values;
    }

    /// Index of the node with that name; where several have it, of the n-th.
    std::size_t node(const std::string& name) const {
        for (std::size_t i = 0; i < json["nodes"].size(); ++i)
            if (json["nodes"][i]["name"] == name) return i;
        FAIL("no node is called " << name);
        return 0;
    }

    /// A node's local transform at a key of the animation, with its scale.
    struct Placed {
        Transform transform;
        double scale = 1.0;
    };
    Placed local(std::size_t index, std::size_t key) const {
        const auto& node = json["nodes"][index];
        Placed placed;
        const auto read = [&](const char* path) -> std::vector<double> {
            for (const auto& channel : json["animations"][0]["channels"]) {
                if (channel["target"]["node"] != index || channel["target"]["path"] != path) continue;
                const auto& sampler = json["animations"][0]["samplers"]
                                          [channel["sampler"].get<std::size_t>()];
                return value(sampler["output"], keyOf(sampler, key));
            }
            return node.contains(path) ? node[path].get<std::vector<double>>() : std::vector<double>{};
        };
        const auto t = read("translation"), r = read("rotation"), s = read("scale");
        if (!t.empty()) placed.transform.translation = point(t);
        if (!r.empty())
            placed.transform.rotation = normalized(Quat{static_cast<float>(r[0]), static_cast<float>(r[1]),
                                                        static_cast<float>(r[2]), static_cast<float>(r[3])});
        if (!s.empty()) placed.scale = s[0];
        return placed;
    }

    static Vec3 point(const std::vector<double>& v) {
        return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
    }

private:
    /// The key for frame `frame`: its own, or with step interpolation the last key not after it.
    std::size_t keyOf(const nlohmann::json& sampler, std::size_t frame) const {
        if (sampler.value("interpolation", "LINEAR") == "LINEAR") return frame;
        const std::size_t input = sampler["input"];
        std::size_t key = 0;
        while (key + 1 < json["accessors"][input]["count"].get<std::size_t>() &&
               value(input, key + 1)[0] <= static_cast<double>(frame) / 30.0 + 1e-6)
            ++key;
        return key;
    }
    static std::uint32_t word(const std::string& bytes, std::size_t at) {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes.data() + at, 4);
        return value;
    }
    static std::size_t partsOf(const std::string& type) {
        return type == "SCALAR" ? 1 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
    }
    static std::size_t sizeOf(int component) { return component == 5121 ? 1 : component < 5125 ? 2 : 4; }
    static double number(const char* from, const nlohmann::json& accessor) {
        const int component = accessor["componentType"];
        const bool share = accessor.value("normalized", false);
        const auto read = [from](auto value) {
            std::memcpy(&value, from, sizeof(value));
            return value;
        };
        if (component == 5126) return static_cast<double>(read(0.0f));
        if (component == 5125) return static_cast<double>(read(std::uint32_t{}));
        if (component == 5123) return static_cast<double>(read(std::uint16_t{}));
        if (component == 5122) return static_cast<double>(read(std::int16_t{})) / (share ? 32767.0 : 1.0);
        return static_cast<double>(read(std::uint8_t{}));
    }

    std::string buffer_;
};

}  // namespace muster::testing
