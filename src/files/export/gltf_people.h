// Characters in a glTF file: skeletons, skins and their animation tracks.
#pragma once

#include <map>

#include "files/export/exporter.h"
#include "files/export/gltf_meshes.h"

namespace muster {

/// Writes all characters of a take. A character that appears late or leaves early has nodes for the whole
/// time, with scale zero while it is absent.
class GltfPeople {
public:
    GltfPeople(GltfDocument& document, GltfBuffer& buffer, GltfMeshes& meshes, std::size_t frames)
        : document_(document), buffer_(buffer), meshes_(meshes), frames_(frames) {}

    /// Number of bytes of one character's tracks.
    static std::uint64_t trackBytes(std::size_t frames);
    /// Adds the characters of the next frame.
    Status frame(const ExportFrame& frame);
    /// Completes all tracks. `times` is the accessor of the frames' times, `fps` the number of frames per
    /// second.
    Status finish(std::uint32_t times, double fps);

private:
    struct Person {
        explicit Person(GltfTrack values) : track(std::move(values)) {}
        GltfTrack track;
        std::uint32_t root = 0;  ///< Index of the root node; the joints follow it.
        float size = 1.0f;
        std::array<Quat, kJointCount + 1> before{};  ///< Rotations of joints and root as last written.
        /// Frames at which the character appears or leaves, alternating.
        std::vector<std::size_t> changes;
        std::size_t seen = 0;  ///< One more than the last frame that contains it.
    };
    Result<Person*> begin(const ExportCharacter& character, const ExportFrame& frame);
    Status addNodes(const ExportCharacter& character, const CharacterLook& look, std::uint32_t root);
    /// Stores the character's values in this frame in record_.
    void makeRecord(const ExportCharacter& character, Person& person);
    void animate(const Person& person, std::uint32_t times);
    Status hide(const Person& person, double fps);

    GltfDocument& document_;
    GltfBuffer& buffer_;
    GltfMeshes& meshes_;
    std::size_t frames_;
    std::map<std::uint32_t, Person> people_;
    std::string record_;
};

}  // namespace muster
