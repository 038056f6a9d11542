// The exporters of takes, one per format.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "engine/ground/environment/environment.h"
#include "files/export/exporter.h"

namespace muster {

/// An exporter that writes to `path`. Fails as exportFormat() does.
Result<std::unique_ptr<Exporter>> makeExporter(std::string_view format, const std::string& path);

/// Writes `folder`/character-ID.bvh for each character: Muster's skeleton at the character's size, with its
/// root in world coordinates, in centimetres (see bvhText). All files have the same frames: a character waits
/// at its first position until it appears, and stays at its last position after it leaves.
std::unique_ptr<Exporter> makeBvhExporter(const std::string& folder);

/// Writes one binary glTF 2.0 file (GLB): a skinned body with skeleton for each character, its shirt in the
/// colour of its group; ground, obstacles and patches as they are at the first frame; a camera that sees all
/// positions of the take. One animation moves everything; it begins at 0 s, at any time of the take. Y is up,
/// bodies face +Z in the rest pose, and one unit is one metre. During the export a second file,
/// PATH.data.part, lies in the same folder. Fails with LimitExceeded where characters and frames exceed the 4
/// GiB of such files.
std::unique_ptr<Exporter> makeGltfExporter(const std::string& path);

/// Writes one JSON object: `joints`, their names; `fps`; and `frames`, each with its `time` from the first
/// frame [s] and `characters`, each with `id` and `positions`: x, y, z of every joint in the world [m],
/// rounded to a micrometre.
std::unique_ptr<Exporter> makeJointListExporter(const std::string& path);

/// Writes JuPedSim's SQLite format, version 2: trajectories with directions, metadata, and the walkable area
/// as WKT. The area is written again whenever the static obstacles change; moving obstacles are left out. A
/// table of its own, muster_data, has the id of the group, heading [rad], motion and goal of PersonFacts.
/// begin() fails with Unsupported where this build has no SQLite.
std::unique_ptr<Exporter> makeJupedsimExporter(const std::string& path);

/// The ground outside all static obstacles as WKT: a POLYGON, or a MULTIPOLYGON where it is in several parts.
/// Discs have 32 corners. Empty where this build has no SQLite.
std::string walkableArea(const Environment& environment);

/// Writes the text that PedPy reads: `# framerate: N`, then one line `id frame x y z group heading motion
/// goal` per character and frame, in metres; PedPy reads the first four. z is 0, the ground; heading is in
/// radians; the others are those of PersonFacts. Frames are numbered from 0.
std::unique_ptr<Exporter> makePedpyExporter(const std::string& path);

/// Writes a table as CSV (RFC 4180) with a head: for each character and frame its time in the take [s], id,
/// id and name of its group, x and y [m], heading [deg] counter-clockwise from +x, speed [m/s], the clip that
/// it plays, and goal of PersonFacts, empty for none.
std::unique_ptr<Exporter> makeCsvExporter(const std::string& path);

/// Writes one USDA file: for each character a SkelRoot with skeleton, animation and a skinned body, its shirt
/// in the colour of its group; ground, obstacles and patches as they are at the first frame; a camera that
/// sees all positions of the take. Z is up, one unit is one metre, and time code 0 is the first frame.
std::unique_ptr<Exporter> makeUsdExporter(const std::string& path);
/// Writes the same as one binary USDC file.
std::unique_ptr<Exporter> makeUsdCrateExporter(const std::string& path);

std::unique_ptr<Exporter> makePlayerExporter(const std::string& path);  ///< For formats.cpp.

}  // namespace muster
