// Scene, bodies and characters of a take as parts of a USD scene.
#pragma once

#include <string>

#include "files/export/character_look.h"
#include "files/export/exporter.h"
#include "files/export/scene_camera.h"
#include "files/export/scene_mesh.h"
#include "files/export/usd_prim.h"

namespace muster {

UsdPrim usdMaterials();  ///< All materials in one scope.
/// The bodies and the skeleton that characters refer to, in one abstract scope.
UsdPrim usdBodies();
/// An object with its meshes. Where it moves it has two tracks: its rotation [deg] and its place.
UsdPrim usdThing(const SceneThing& thing);
UsdPrim usdCamera(const SceneCamera& camera);

/// The tracks of a character, in their order.
enum class UsdPersonTrack : std::uint8_t {
    Place,       ///< On the ground [m].
    Turn,        ///< [deg]
    Hips,        ///< Beside where they are in the rest pose, in the character's own axes [m].
    Visibility,  ///< "inherited" or "invisible".
    Rotations,   ///< Of all joints.
    Count
};
inline constexpr std::size_t kUsdPersonTracks = static_cast<std::size_t>(UsdPersonTrack::Count);
/// The values of a character in one frame, of each track; `turn` is its heading [rad].
using UsdPersonValues = std::array<std::vector<double>, kUsdPersonTracks>;
UsdPersonValues usdPersonValues(const ExportCharacter& character, double turn);
/// A character with its skeleton, animation and body.
UsdPrim usdPerson(const ExportCharacter& character, const CharacterLook& look, const UsdPersonValues& first);

}  // namespace muster
