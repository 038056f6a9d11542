// Pieces of USD text.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/output_file.h"
#include "io/export/character_look.h"
#include "io/export/scene_camera.h"
#include "io/export/scene_mesh.h"

namespace muster {

/// A name as USD takes it: letters, digits and underscores, no digit in front.
std::string usdName(std::string_view name);
std::string usdNumber(double value);  ///< With seven digits.
std::string usdPoint(Vec3 p);         ///< "(x, y, z)".
/// A number in exactly `width` columns, with `decimals` where they fit.
void usdFixed(double value, int width, int decimals, std::string& text);

/// All materials, as one scope.
std::string usdMaterials();
/// The bodies and the skeleton that characters refer to, as one abstract scope.
std::string usdBodies();
/// A thing with its meshes; its path as samples, `frames` of them from `from` [s].
std::string usdThing(const SceneThing& thing, double from, double fps, std::size_t frames);
std::string usdCamera(const SceneCamera& camera);  ///< The camera.
/// "[Hips, Hips/Spine, ...]" in quotes, as USD names joints.
std::string usdJoints();

/// Lines of equal length, one a frame, in a stretch of a file set aside for them: buffered for some frames,
/// then written.
class UsdSamples {
public:
    /// For so many lines of `width` bytes each, the line's end included.
    UsdSamples(std::size_t frames, std::size_t width) : frames_(frames), width_(width) {}

    /// Sets aside the stretch at the end of the file. Fails as the file does.
    Status reserve(OutputFile& file);
    /// Adds a frame's line.
    Status add(OutputFile& file, std::string_view line);
    /// Writes what is buffered.
    Status flush(OutputFile& file);

private:
    std::size_t frames_, width_;
    std::uint64_t begin_ = 0;
    std::size_t filled_ = 0;
    std::string lines_;
};

}  // namespace muster
