// Building blocks of USD text.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/output_file.h"
#include "files/export/character_look.h"
#include "files/export/scene_camera.h"
#include "files/export/scene_mesh.h"

namespace muster {

/// A valid USD name: letters, digits and underscores, not beginning with a digit.
std::string usdName(std::string_view name);
std::string usdNumber(double value);  ///< Formats with seven digits.
std::string usdPoint(Vec3 p);         ///< Formats as "(x, y, z)".
/// A number in exactly `width` columns, with `decimals` where they fit.
void usdFixed(double value, int width, int decimals, std::string& text);

/// All materials in one scope.
std::string usdMaterials();
/// The material of a shirt whose colour was chosen, in the prim of that path.
std::string usdShirt(const NamedColour& colour, const std::string& scope);
/// The bodies and the skeleton that characters refer to, in one abstract scope.
std::string usdBodies();
/// An object with its meshes. Its path becomes samples, `frames` of them from `from` [s].
std::string usdThing(const SceneThing& thing, double from, double fps, std::size_t frames);
std::string usdCamera(const SceneCamera& camera);  ///< Formats the camera as a prim.
/// The joint names in USD's form: "[Hips, Hips/Spine, ...]" in quotes.
std::string usdJoints();

/// Lines of equal length, one per frame, in a reserved range of a file. Some frames are buffered before they
/// are written.
class UsdSamples {
public:
    /// The number of lines and the bytes of each, with its end of line.
    UsdSamples(std::size_t frames, std::size_t width) : frames_(frames), width_(width) {}

    /// Reserves the range at the end of the file. Fails with write errors.
    Status reserve(OutputFile& file);
    /// Adds a frame's line.
    Status add(OutputFile& file, std::string_view line);
    /// Writes the buffered lines.
    Status flush(OutputFile& file);

private:
    std::size_t frames_, width_;
    std::uint64_t begin_ = 0;
    std::size_t filled_ = 0;
    std::string lines_;
};

}  // namespace muster
