#include "shelf_desk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "http_answers.h"
#include "io/take/take_about.h"
#include "json/json.h"

namespace muster {
namespace {

constexpr std::size_t kShelfBytes = std::size_t{96} << 20;
constexpr std::size_t kRequestBytes = 4096;  // What a request without a body counts for.
constexpr double kShelfWait = 3600.0;        // [s]

HttpAnswer jsonAnswer(const Json& value) {
    HttpAnswer answer;
    answer.type = "application/json";
    answer.body = compactJson(value) + "\n";
    return answer;
}

HttpAnswer doneAnswer(const Status& status) {
    return status.ok() ? jsonAnswer(Json::object()) : failure(status);
}

HttpAnswer fileAnswer(const Result<std::string>& path, const char* type, const std::string& saveAs = {}) {
    if (!path.ok()) return failure(path.status());
    HttpAnswer answer;
    answer.type = type;
    answer.path = *path;
    answer.fileName = saveAs;
    return answer;
}

Json toJson(const ShelvedTake& take) {
    const std::uint32_t first = take.about.firstStep(take.steps), last = take.about.lastStep(take.steps);
    Json value = {{"name", take.name}, {"title", take.about.title}, {"scenario", take.scenario}};
    value["characters"] = take.characters;
    value["steps"] = take.steps;
    value["stepTime"] = take.stepTime;
    value["from"] = first;
    value["to"] = last;
    value["seconds"] = (last - first) * take.stepTime;
    value["finished"] = take.finished;
    value["recording"] = take.recording;
    value["picture"] = take.picture;
    value["changed"] = take.changed;
    value["bytes"] = take.bytes;
    value["speeds"] = Json::array();
    for (const SpeedPiece& piece : take.about.speeds)
        value["speeds"].push(
            {{"from", piece.from}, {"to", piece.to}, {"speed", piece.speed}, {"ease", piece.ease}});
    return value;
}

std::string textOf(const std::vector<std::uint8_t>& bytes) {
    return {bytes.begin(), bytes.end()};
}

const char* nameOf(ExportState state) {
    switch (state) {
        case ExportState::Waiting:
            return "waiting";
        case ExportState::Running:
            return "running";
        case ExportState::Done:
            return "done";
        case ExportState::Failed:
            break;
    }
    return "failed";
}

/// The order that a request's text spells out.
Result<ExportOrder> readOrder(const std::string& text) {
    const auto value = parseJson(text, "export");
    if (!value.ok()) return value.status();
    if (!value->isObject())
        return invalidArgument("export: found " + describeJson(*value) + ", expected an object");
    ExportOrder order;
    for (const auto& [key, target] :
         {std::pair<const char*, std::string*>{"take", &order.take}, {"format", &order.format}}) {
        const Json* found = value->find(key);
        if (found == nullptr || !found->isText())
            return invalidArgument(std::string("export: expected a text for ") + key);
        *target = found->text();
    }
    for (const auto& [key, target] :
         {std::pair<const char*, double*>{"from", &order.from}, {"to", &order.to}, {"fps", &order.fps}}) {
        const Json* found = value->find(key);
        if (found == nullptr) continue;
        if (!found->isNumber() || !std::isfinite(found->number()))
            return invalidArgument(std::string("export: found ") + describeJson(*found) + " for " + key +
                                   ", expected a number");
        *target = found->number();
    }
    if (const Json* speeds = value->find("speeds"); speeds != nullptr && speeds->isBoolean())
        order.speeds = speeds->boolean();
    return order;
}

}  // namespace

ShelfDesk::ShelfDesk(TakeShelf& shelf, ExportDesk& exports, OpenTake open, TakeEdited edited)
    : shelf_(shelf),
      exports_(exports),
      open_(std::move(open)),
      edited_(std::move(edited)),
      mailbox_(kShelfBytes),
      thread_([this] { run(); }) {}

ShelfDesk::~ShelfDesk() {
    mailbox_.post(Post{{}, {}, true});
    thread_.join();
}

bool ShelfDesk::post(ShelfRequest request, HttpReply reply) {
    const std::size_t bytes = request.body.size() + kRequestBytes;
    return mailbox_.post(Post{std::move(request), std::move(reply), false}, bytes);
}

void ShelfDesk::run() {
    std::vector<Post> posts;
    while (true) {
        mailbox_.collect(kShelfWait, posts);
        for (Post& post : posts) {
            if (post.end) return;
            if (post.request.action == ShelfAction::Open)
                open(post.request, post.reply);
            else
                post.reply(answer(post.request));
        }
    }
}

void ShelfDesk::open(const ShelfRequest& request, const HttpReply& reply) {
    const auto text = shelf_.read(request.name);
    if (!text.ok()) return reply(failure(text.status()));
    open_({text->begin(), text->end()}, request.name, reply);
}

HttpAnswer ShelfDesk::answer(ShelfRequest& request) {
    switch (request.action) {
        case ShelfAction::List: {
            Json list = Json::array();
            for (const ShelvedTake& take : shelf_.list()) list.push(toJson(take));
            return jsonAnswer({{"takes", list}});
        }
        case ShelfAction::Put: {
            const auto name = shelf_.put(request.body);
            return name.ok() ? jsonAnswer({{"name", *name}}) : failure(name.status());
        }
        case ShelfAction::Download:
            return fileAnswer(shelf_.pathOf(request.name), "application/octet-stream", request.name);
        case ShelfAction::Edit:
            return edit(request);
        case ShelfAction::Remove:
            return doneAnswer(shelf_.remove(request.name));
        case ShelfAction::Restore:
            return doneAnswer(shelf_.restore(request.name));
        case ShelfAction::ShowPicture:
            return fileAnswer(shelf_.pictureOf(request.name), "image/png");
        case ShelfAction::PutPicture:
            return doneAnswer(shelf_.putPicture(request.name, request.body));
        case ShelfAction::BeginExport:
            return beginExport(request);
        case ShelfAction::ShowExport:
            return showExport(request, false);
        case ShelfAction::CancelExport:
            return doneAnswer(exports_.cancel(request.name));
        case ShelfAction::DownloadExport:
            return showExport(request, true);
        case ShelfAction::Open:
            break;
    }
    return sentence(404, "There is no such take.");
}

HttpAnswer ShelfDesk::edit(const ShelfRequest& request) {
    const auto about = readTakeAbout(textOf(request.body), "take");
    if (!about.ok()) return failure(about.status());
    const Status status = shelf_.edit(request.name, *about);
    if (status.ok()) edited_(request.name, *about);
    return doneAnswer(status);
}

HttpAnswer ShelfDesk::beginExport(const ShelfRequest& request) {
    auto order = readOrder(textOf(request.body));
    if (!order.ok()) return failure(order.status());
    const auto path = shelf_.pathOf(order->take);
    if (!path.ok()) return failure(path.status());
    order->title = order->take.substr(0, order->take.rfind('.'));
    for (const ShelvedTake& take : shelf_.list())
        if (take.name == order->take && !take.about.title.empty()) order->title = take.about.title;
    order->take = *path;
    const auto number = exports_.begin(std::move(order).value());
    return number.ok() ? jsonAnswer({{"number", *number}}) : failure(number.status());
}

HttpAnswer ShelfDesk::showExport(const ShelfRequest& request, bool asFile) {
    const auto report = exports_.report(request.name);
    if (!report.ok()) return failure(report.status());
    if (asFile) {
        if (report->state != ExportState::Done) return sentence(404, "The export is not done.");
        return fileAnswer(report->path, "application/octet-stream", report->fileName);
    }
    Json value = {{"state", nameOf(report->state)}, {"share", report->share}, {"file", report->fileName}};
    value["bytes"] = report->bytes;
    if (!report->problem.empty()) value["problem"] = report->problem;
    return jsonAnswer(value);
}

}  // namespace muster
