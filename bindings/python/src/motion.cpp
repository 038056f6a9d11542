// muster.CrowdMotion
#include <memory>

#include "array_view.h"
#include "muster/motion.h"
#include "python_world.h"

namespace muster::python {
namespace {

static_assert(sizeof(Transform) == 7 * sizeof(float));

/// The clips' names in the order of the library.
py::list clipNames(const CrowdMotion& motion) {
    py::list names;
    for (const Clip& clip : motion.library().clips) names.append(clip.name);
    return names;
}

/// The joints of all characters: positions (n, 21, 3) and rotations (n, 21, 4).
py::tuple joints(const CrowdMotion& motion) {
    const std::size_t count = motion.near().size();
    const auto rows = static_cast<py::ssize_t>(count);
    constexpr auto kJoints = static_cast<py::ssize_t>(kJointCount);
    py::array_t<std::uint32_t> ids(rows);
    py::array_t<float> positions({rows, kJoints, py::ssize_t{3}});
    py::array_t<float> rotations({rows, kJoints, py::ssize_t{4}});
    auto id = ids.mutable_unchecked<1>();
    auto position = positions.mutable_unchecked<3>();
    auto rotation = rotations.mutable_unchecked<3>();
    JointTransforms transforms;
    for (py::ssize_t k = 0; k < rows; ++k) {
        const auto body = static_cast<std::size_t>(k);
        worldJoints(motion.states()[motion.near()[body]], motion.pose(body), transforms);
        id(k) = motion.nearId(body);
        for (py::ssize_t j = 0; j < kJoints; ++j) {
            const Transform& joint = transforms[static_cast<std::size_t>(j)];
            const float at[] = {joint.translation.x, joint.translation.y, joint.translation.z};
            const float turn[] = {joint.rotation.x, joint.rotation.y, joint.rotation.z, joint.rotation.w};
            for (py::ssize_t c = 0; c < 3; ++c) position(k, j, c) = at[c];
            for (py::ssize_t c = 0; c < 4; ++c) rotation(k, j, c) = turn[c];
        }
    }
    return py::make_tuple(ids, positions, rotations);
}

/// Clip and time of each character, as an array of records.
py::array states(const CrowdMotion& motion) {
    py::list names, formats, offsets;
    const auto field = [&](const char* name, const py::dtype& type, std::size_t offset) {
        names.append(name);
        formats.append(type);
        offsets.append(offset);
    };
    const auto number = py::dtype::of<float>();
    field("clip", py::dtype::of<std::uint16_t>(), offsetof(MotionState, clip));
    field("from_clip", py::dtype::of<std::uint16_t>(), offsetof(MotionState, fromClip));
    field("time", number, offsetof(MotionState, time));
    field("from_time", number, offsetof(MotionState, fromTime));
    field("fade", number, offsetof(MotionState, fade));
    field("position", py::dtype::from_args(py::make_tuple(py::dtype::of<double>(), 2)),
          offsetof(MotionState, position));
    field("yaw", number, offsetof(MotionState, yaw));
    field("size", number, offsetof(MotionState, size));
    const std::span<const MotionState> all = motion.states();
    return py::array(py::dtype(names, formats, offsets, sizeof(MotionState)),
                     std::vector<py::ssize_t>{static_cast<py::ssize_t>(all.size())}, all.data());
}

py::list jointNames() {
    py::list names;
    for (const Joint& joint : skeleton()) names.append(joint.name);
    return names;
}

py::list jointParents() {
    py::list parents;
    for (const Joint& joint : skeleton()) parents.append(joint.parent);
    return parents;
}

}  // namespace

void defineMotion(py::module_& module) {
    py::class_<CrowdMotion>(
        module, "CrowdMotion",
        "The motion of all characters of a world by Muster's own clips: which clip each plays, and its\n"
        "pose with feet on the floor. Reads the world and never changes it.")
        .def(py::init([] { return std::make_unique<CrowdMotion>(ownClips()); }))
        .def(
            "update", [](CrowdMotion& self, WorldHandle& world) { self.update(world.get()); },
            py::arg("world"), "Call after every single step of the world.")
        .def("states", &states,
             "Clip and time of each character, a copy. Shape (n,), records: clip and from_clip (indices into "
             "`clips`), time and\n"
             "from_time [s], fade (share of from_clip), position (2) [m], yaw [rad], size (factor of the "
             "skeleton).")
        .def("joints", &joints,
             "The joints of all characters in the world, copies: ids (n,), positions (n, 21, 3) [m], z up, "
             "and rotations\n"
             "(n, 21, 4) as quaternions x, y, z, w. The order of joints is that of muster.JOINTS.")
        .def_property_readonly("clips", &clipNames, "Names of the clips.");
    module.attr("JOINTS") = py::tuple(jointNames());
    module.attr("JOINT_PARENTS") = py::tuple(jointParents());
}

}  // namespace muster::python
