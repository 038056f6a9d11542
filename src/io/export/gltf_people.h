// Characters in a glTF file: skeletons, skins and their tracks.
#pragma once

#include <map>

#include "io/export/exporter.h"
#include "io/export/gltf_meshes.h"

namespace muster {

/// Writes all characters of a take. Who comes late or goes early is there all the time, of size nothing while
/// away.
class GltfPeople {
public:
    GltfPeople(GltfDocument& document, GltfBuffer& buffer, GltfMeshes& meshes, std::size_t frames)
        : document_(document), buffer_(buffer), meshes_(meshes), frames_(frames) {}

    /// Bytes that one character's tracks take.
    static std::uint64_t trackBytes(std::size_t frames);
    /// Takes the characters of the next frame.
    Status frame(const ExportFrame& frame);
    /// Completes all tracks; `times` is the accessor of the frames' times, `fps` their pace.
    Status finish(std::uint32_t times, double fps);

private:
    struct Person {
        explicit Person(GltfTrack values) : track(std::move(values)) {}
        GltfTrack track;
        std::uint32_t root = 0;  ///< Its node; joints follow.
        float size = 1.0f;
        std::array<Quat, kJointCount + 1> before{};  ///< Of joints and root, as last written.
        std::vector<std::size_t> changes;            ///< Frames at which it comes, goes, comes again...
        std::size_t seen = 0;                        ///< One more than the last frame it was in.
    };
    Result<Person*> begin(const ExportCharacter& character, const ExportFrame& frame);
    Status addNodes(const ExportCharacter& character, const CharacterLook& look, std::uint32_t root);
    /// The character's values in this frame as bytes, in record_.
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
