// A square with a fountain, where people are directed by sentences, and what has become of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "base/maths.h"
#include "studio/session/fake_client.h"

namespace muster::testing {

inline Polygon wordsBox(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// North, South and the Red guard round a fountain, with exits, a waiting room, a hall and a pool.
inline WorldDef wordsSquare() {
    WorldDef def{.name = "Square", .box = {{-30, -30}, {30, 30}}};
    def.groups = {{.name = "North", .count = 40, .position = {0, 15}, .angle = -kPi / 2},
                  {.name = "South",
                   .count = 24,
                   .formation = {.kind = FormationKind::Wedge},
                   .position = {0, -15},
                   .angle = kPi / 2},
                  {.name = "Red guard",
                   .count = 20,
                   .formation = {.kind = FormationKind::Line},
                   .position = {-12, 0},
                   .colour = 0xC02020u}};
    def.obstacles = {{.name = "Fountain", .centre = {14, 0}, .radius = 2.0},
                     {.name = "Town hall", .polygon = wordsBox(-26, 14, -18, 20)}};
    def.areas = {{.name = "Main exit", .kind = AreaKind::Exit, .polygon = wordsBox(27, -28, 30, -24)},
                 {.name = "Side exit", .kind = AreaKind::Exit, .polygon = wordsBox(-30, -4, -28, -1)},
                 {.name = "Waiting room", .kind = AreaKind::Waiting, .polygon = wordsBox(16, 16, 26, 26)}};
    PatchDef pool{.name = "Pool", .polygon = wordsBox(-20, -24, -12, -16)};
    def.patches = {pool};
    return def;
}

/// A session in that square with one director.
struct WordsStage {
    Session session{sessionDef()};
    FakeClient client{session};
    std::map<std::string, std::vector<std::uint32_t>> began;  ///< Ids by the groups of the beginning.
    std::map<std::uint32_t, Vec2> stood;                      ///< Where they stood.

    WordsStage() {
        REQUIRE(session.load("square", wordsSquare()).ok());
        settle(0.2);
        for (std::size_t g = 0; g < world().groupCount(); ++g)
            for (const std::int32_t i : world().group(g).members) {
                began[std::string(world().group(g).name)].push_back(idOf(i));
                stood[idOf(i)] = world().characters().position[static_cast<std::size_t>(i)];
            }
    }
    const World& world() const { return *session.world(); }
    std::uint32_t idOf(std::int32_t i) const { return world().characters().id[static_cast<std::size_t>(i)]; }
    void settle(double seconds) { run(session, seconds, {&client}); }

    /// Says a sentence and takes the answer.
    protocol::Said ask(const std::string& text, protocol::SayAct act) {
        protocol::Say say;
        say.number = ++number_;
        say.text = text;
        say.act = act;
        client.send(say);
        client.poll();
        REQUIRE(!client.said.empty());
        CHECK(client.said.back().number == number_);
        return client.said.back();
    }
    protocol::Said say(const std::string& text) { return ask(text, protocol::SayAct::Do); }

    bool isThere(const std::string& name) const { return find(name) < world().groupCount(); }
    GroupView group(const std::string& name) const {
        REQUIRE_MESSAGE(isThere(name), name);
        return world().group(find(name));
    }
    /// Where people are, by their ids; those who have left are left out.
    std::vector<Vec2> at(const std::vector<std::uint32_t>& ids) const {
        std::vector<Vec2> all;
        const CharactersView people = world().characters();
        for (std::size_t i = 0; i < people.size(); ++i)
            if (std::find(ids.begin(), ids.end(), people.id[i]) != ids.end())
                all.push_back(people.position[i]);
        return all;
    }
    /// How many of those who began in a group are within a distance of a point.
    std::size_t near(const std::string& name, Vec2 to, double within) const {
        const std::vector<Vec2> all = at(began.at(name));
        return static_cast<std::size_t>(
            std::count_if(all.begin(), all.end(), [&](Vec2 p) { return distance(p, to) <= within; }));
    }
    /// How many of them are still about where they stood at first.
    std::size_t stayed(const std::string& name, double within = 1.5) const {
        std::size_t count = 0;
        for (const std::uint32_t id : began.at(name))
            for (const Vec2 p : at({id})) count += distance(p, stood.at(id)) <= within ? 1u : 0u;
        return count;
    }
    std::size_t left(const std::string& name) const { return at(began.at(name)).size(); }
    Vec2 middle(const std::string& name) const {
        Vec2 sum;
        const std::vector<Vec2> all = at(began.at(name));
        for (const Vec2 p : all) sum += p;
        return sum / std::max(1.0, static_cast<double>(all.size()));
    }
    /// How far the front of a group is turned from a heading [rad].
    double turned(const std::string& name, double heading) const {
        const Rotation front = group(name).pose.rotation;
        return std::abs(arcTangent2(front.s * cosine(heading) - front.c * sine(heading),
                                    front.c * cosine(heading) + front.s * sine(heading)));
    }
    /// The mean distance of each from the nearest other one.
    double spacing(const std::string& name) const {
        const std::vector<Vec2> all = at(began.at(name));
        double sum = 0.0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            double least = 1e9;
            for (std::size_t j = 0; j < all.size(); ++j)
                if (j != i) least = std::min(least, distance(all[i], all[j]));
            sum += least;
        }
        return sum / std::max(1.0, static_cast<double>(all.size()));
    }

private:
    std::size_t find(const std::string& name) const {
        std::size_t g = 0;
        while (g < world().groupCount() && world().group(g).name != name) ++g;
        return g;
    }
    std::uint32_t number_ = 0;
};

}  // namespace muster::testing
