#include "shelf_answers.h"

#include <utility>

#include "files/take/take_format.h"
#include "http_answers.h"
#include "json/json.h"

namespace muster {
namespace {

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

}  // namespace

ShelfAnswers::ShelfAnswers(TakeShelf& shelf, TakeEdited edited) : shelf_(shelf), edited_(std::move(edited)) {}

HttpAnswer ShelfAnswers::answer(const ShelfRequest& request) {
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
        case ShelfAction::ShowExport:
        case ShelfAction::CancelExport:
        case ShelfAction::DownloadExport:
        case ShelfAction::Open:
            break;
    }
    return sentence(404, "There is no such take.");
}

HttpAnswer ShelfAnswers::edit(const ShelfRequest& request) {
    auto about = readTakeAbout(textOf(request.body), "take");
    if (!about.ok()) return failure(about.status());
    // Pages say here how a take is called and which part plays.
    const Status status = shelf_.edit(request.name, *about, false);
    if (status.ok()) edited_(request.name, *about);
    return doneAnswer(status);
}

}  // namespace muster
