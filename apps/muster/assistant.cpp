#include "assistant.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "engine/state/command_archive.h"
#include "muster/scenario.h"

namespace muster {
namespace {

using namespace std::chrono_literals;

constexpr int kParseError = -32700, kInvalidRequest = -32600, kNoMethod = -32601, kInvalidParams = -32602;
constexpr auto kPatience = 10s;   // For an answer of the studio.
constexpr auto kSettled = 300ms;  // The world has refused by then what it refuses.
constexpr std::array kRevisions{"2025-11-25", "2025-06-18", "2025-03-26", "2024-11-05"};
constexpr const char* kInstructions =
    "You direct a crowd in a running studio, together with people who watch. Call look first: it tells the "
    "groups, the things on the ground and where they are. Then say what groups shall do, in plain English: "
    "'Half of North to Fountain in a ring, the rest hold'. With preview true nothing is done, and you hear "
    "what "
    "would be. undo takes back your last step.";

struct Tool {
    const char* name;
    const char* about;
    const char* schema;  // Of its arguments, as JSON.
};
constexpr std::array kTools{
    Tool{
        "look",
        "Tells what there is: groups with their people, places, shapes and orders, things with their places, "
        "the time, and a map from above.",
        R"({"type":"object","properties":{}})"},
    Tool{
        "say",
        "Directs by a sentence: go to, by way of, follow, guard, patrol between, leave by, wait in, face, "
        "stop, hold, form a ring, line, column, square, wedge, circle or crescent, spread out, split, merge, "
        "swap places, rename, faster, slower; for groups by name or colour, everybody, half of, a third of, "
        "20 of, the rest. Answers with what each group does, or with what was not understood.",
        R"({"type":"object","properties":{"sentence":{"type":"string","description":"What the groups shall do."},)"
        R"("preview":{"type":"boolean","description":"True: only tell what would come of it."}},)"
        R"("required":["sentence"]})"},
    Tool{"do",
         "Gives exact commands, as gesture files of Muster have them: "
         R"([{"kind":"move","group":1,"x":3,"y":4}].)",
         R"({"type":"object","properties":{"commands":{"type":"array","items":{"type":"object"},)"
         R"("description":"Commands, at least one."}},"required":["commands"]})"},
    Tool{"undo", "Takes back your last step.", R"({"type":"object","properties":{}})"},
    Tool{"redo", "Does again what you took back.", R"({"type":"object","properties":{}})"},
    Tool{"play", "Lets time go on.", R"({"type":"object","properties":{}})"},
    Tool{"pause", "Stops time.", R"({"type":"object","properties":{}})"},
};

const Json* objectAt(const Json* of, std::string_view key) {
    const Json* found = of == nullptr ? nullptr : of->find(key);
    return found != nullptr && found->isObject() ? found : nullptr;
}

Json toolList() {
    Json tools = Json::array();
    for (const Tool& tool : kTools) {
        Json schema = parseJson(tool.schema, tool.name).value();
        tools.push({{"name", tool.name}, {"description", tool.about}, {"inputSchema", std::move(schema)}});
    }
    return {{"tools", std::move(tools)}};
}

std::string failure(const Json& id, int code, const std::string& message) {
    return compactJson({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", message}}}});
}

std::string timeText(float value) {
    return value < 1e6f ? std::to_string(std::lround(value)) + " s" : "no time that is known";
}

/// What a preview tells of ways and places.
std::string outlook(const protocol::Said& said) {
    std::string text;
    for (const protocol::ForecastFrame& one : said.forecasts) {
        text += "\nGroup " + std::to_string(one.group) + ": ";
        text += one.arrives ? "would arrive in " + timeText(one.seconds) + "." : "cannot get all the way.";
    }
    std::size_t all = 0, unfit = 0;
    for (const protocol::PlacesFrame& places : said.places) {
        all += places.unfit.size();
        unfit += static_cast<std::size_t>(std::count_if(places.unfit.begin(), places.unfit.end(),
                                                        [](std::uint8_t bar) { return bar != 0; }));
    }
    if (unfit > 0)
        text += "\n" + std::to_string(unfit) + " of " + std::to_string(all) + " places cannot be reached.";
    return text;
}

}  // namespace

std::optional<std::string> Assistant::answer(std::string_view line) {
    const Result<Json> read = parseJson(line, "message");
    if (!read.ok()) return failure(nullptr, kParseError, read.status().message());
    const Json& message = *read;
    const Json* id = message.find("id");
    const Json* method = message.find("method");
    const Json* version = message.find("jsonrpc");
    if (method == nullptr && id != nullptr && (message.contains("result") || message.contains("error")))
        return std::nullopt;  // An answer to what nobody has asked.
    if (method == nullptr || !method->isText() || version == nullptr || !version->isText() ||
        version->text() != "2.0" || (id != nullptr && !id->isText() && !id->isWhole()))
        return failure(nullptr, kInvalidRequest, "found no request of JSON-RPC 2.0");
    if (id == nullptr) return std::nullopt;
    std::string problem;
    int code = 0;
    Json made = result(method->text(), objectAt(&message, "params"), problem, code);
    if (code != 0) return failure(*id, code, problem);
    return compactJson({{"jsonrpc", "2.0"}, {"id", *id}, {"result", std::move(made)}});
}

Json Assistant::result(const std::string& method, const Json* params, std::string& problem, int& code) {
    if (method == "initialize") return initialize(params);
    if (method == "ping") return Json::object();
    if (method == "tools/list") return toolList();
    if (method == "tools/call") return call(params, problem, code);
    code = kNoMethod;
    problem = "there is no method '" + method.substr(0, 60) + "'";
    return {};
}

Json Assistant::initialize(const Json* params) const {
    std::string revision = kRevisions.front();
    const Json* wanted = params == nullptr ? nullptr : params->find("protocolVersion");
    for (const char* known : kRevisions)
        if (wanted != nullptr && wanted->isText() && wanted->text() == known) revision = known;
    return {{"protocolVersion", revision},
            {"capabilities", {{"tools", Json::object()}}},
            {"serverInfo", {{"name", "muster"}, {"version", MUSTER_VERSION}}},
            {"instructions", kInstructions}};
}

Json Assistant::call(const Json* params, std::string& problem, int& code) {
    const Json* name = params == nullptr ? nullptr : params->find("name");
    const std::string tool = name != nullptr && name->isText() ? name->text() : "";
    const Json* given = objectAt(params, "arguments");
    const Json arguments = given != nullptr ? *given : Json::object();
    using protocol::PlaybackAction;
    Outcome outcome;
    if (tool == "look") {
        outcome = look();
    } else if (tool == "say") {
        outcome = say(arguments);
    } else if (tool == "do") {
        outcome = give(arguments);
    } else if (tool == "undo" || tool == "redo") {
        outcome = act(protocol::encode(protocol::UndoEdit{tool == "redo"}),
                      tool == "redo" ? "Done again." : "Taken back.");
    } else if (tool == "play" || tool == "pause") {
        const PlaybackAction action = tool == "play" ? PlaybackAction::Play : PlaybackAction::Pause;
        outcome = act(protocol::encode(protocol::Playback{action}),
                      tool == "play" ? "Time goes on." : "Time stands.");
    } else {
        code = kInvalidParams;
        problem = "there is no tool '" + tool.substr(0, 60) + "'";
        return {};
    }
    return {{"content", Json::array({Json{{"type", "text"}, {"text", outcome.text}}})},
            {"isError", outcome.failed}};
}

Assistant::Outcome Assistant::spoken(protocol::SayAct act, const std::string& text) {
    link_.forget();
    protocol::Say say;
    say.number = ++number_;
    say.act = act;
    say.text = text;
    if (const Status sent = link_.send(protocol::encode(say)); !sent.ok()) return {sent.message(), true};
    Outcome outcome;
    const bool came = link_.await(kPatience, [&](const protocol::ServerMessage& message) {
        if (const auto* notice = std::get_if<protocol::Notice>(&message);
            notice != nullptr && notice->code == "Say")
            return outcome = {notice->text, true}, true;
        const auto* said = std::get_if<protocol::Said>(&message);
        if (said == nullptr || said->number != number_) return false;
        outcome = said->problem.empty() ? Outcome{said->sentences + outlook(*said), false}
                                        : Outcome{said->problem, true};
        return true;
    });
    return came ? outcome : Outcome{"The studio does not answer.", true};
}

Assistant::Outcome Assistant::look() {
    return spoken(protocol::SayAct::Look, "");
}

Assistant::Outcome Assistant::say(const Json& arguments) {
    const Json* sentence = arguments.find("sentence");
    if (sentence == nullptr || !sentence->isText()) return {"Give a sentence.", true};
    const Json* preview = arguments.find("preview");
    const bool looks = preview != nullptr && preview->isBoolean() && preview->boolean();
    Outcome outcome = spoken(looks ? protocol::SayAct::Preview : protocol::SayAct::Do, sentence->text());
    if (outcome.failed || looks) return outcome;
    const std::string trouble = troubles();
    return trouble.empty() ? outcome : Outcome{outcome.text + "\nBut: " + trouble, true};
}

Assistant::Outcome Assistant::give(const Json& arguments) {
    const Json* commands = arguments.find("commands");
    if (commands == nullptr || !commands->isArray() || commands->empty())
        return {"Give at least one command.", true};
    const auto read = parseCommands(compactJson(*commands), "commands", 1.0 / 60.0);
    if (!read.ok()) return {read.status().message(), true};
    Writer writer;
    for (const Command& command : *read) encodeBody(writer, command.body);
    return act(protocol::encode(protocol::Commands{writer.take()}), "Done.");
}

Assistant::Outcome Assistant::act(std::vector<std::uint8_t> bytes, const std::string& done) {
    link_.forget();
    if (const Status sent = link_.send(std::move(bytes)); !sent.ok()) return {sent.message(), true};
    const std::string trouble = troubles();
    return trouble.empty() ? Outcome{done, false} : Outcome{trouble, true};
}

std::string Assistant::troubles() {
    std::string text;
    link_.await(kSettled, [&](const protocol::ServerMessage& message) {
        const auto* notice = std::get_if<protocol::Notice>(&message);
        const bool ours = notice != nullptr &&
                          (notice->level == protocol::NoticeLevel::Error ||
                           (notice->level == protocol::NoticeLevel::Warning && notice->code == "rejected"));
        if (ours) text += (text.empty() ? "" : " ") + notice->text;
        return false;
    });
    return text;
}

}  // namespace muster
