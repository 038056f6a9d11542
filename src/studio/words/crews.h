// Who is meant: groups and parts of them, which become groups of their own.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/maths.h"
#include "muster/status.h"
#include "studio/words/clauses.h"
#include "studio/words/words.h"

namespace muster::words {

/// A group, or the people of one who are to become a group.
struct Crew {
    GroupId group;                   ///< The group that they are in.
    GroupId address;                 ///< The same, or what stands in for the part's id.
    std::vector<std::uint32_t> ids;  ///< Its people, ascending.
    bool whole = true;               ///< They are, or stay, that group.
    bool all = true;                 ///< They are all people of the group.
    std::string label;               ///< "North", "20 of North".
    Vec2 middle;                     ///< Where they stand [m].
    Rotation front;                  ///< Where the group faces.
    FormationDef formation;          ///< What the group is in.

    std::int32_t count() const { return static_cast<std::int32_t>(ids.size()); }
    double heading() const { return arcTangent2(front.s, front.c); }  ///< Where the group faces [rad].
};

/// Finds them, one subject of the text after the other.
class Crews {
public:
    Crews(const WordsScene& scene, const KnownNames& names) : scene_(scene), names_(names) {}

    /// Those whom it means. `near`: who is nearest to there comes first, where only some are wanted; null for
    /// nowhere. Fails with a sentence for people.
    Result<std::vector<Crew>> of(const std::optional<Who>& who, const Vec2* near);
    /// The commands that divide groups, and the parts.
    const std::vector<CommandBody>& splits() const { return splits_; }
    const std::vector<WordsPart>& parts() const { return parts_; }
    Crew whole(GroupId group) const;

private:
    Result<std::vector<GroupId>> base(const Who& who);
    Result<std::vector<Crew>> some(const Who& who, const std::vector<GroupId>& groups, const Vec2* near);
    std::vector<GroupId> restOf(const Who& who) const;
    Crew part(GroupId group, std::vector<std::uint32_t> ids);
    std::vector<std::uint32_t> members(GroupId group) const;
    std::vector<std::uint32_t> left(GroupId group) const;
    Vec2 placeOf(std::uint32_t character) const;
    void sortBy(std::vector<std::uint32_t>& ids, const Who& who, GroupId group, const Vec2* near) const;

    const WordsScene& scene_;
    const KnownNames& names_;
    std::map<GroupId, std::vector<std::uint32_t>> taken_;  // Who has become a part, ascending.
    std::vector<GroupId> base_;                            // The groups named last.
    std::vector<GroupId> mentioned_;
    std::vector<Crew> last_;
    std::vector<CommandBody> splits_;
    std::vector<WordsPart> parts_;
};

}  // namespace muster::words
