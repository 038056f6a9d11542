#include "shelf_desk.h"

#include <utility>

#include "http_answers.h"

namespace muster {
namespace {

constexpr std::size_t kShelfBytes = std::size_t{96} << 20;
constexpr std::size_t kRequestBytes = 4096;  // What a request without a body counts for.
constexpr double kShelfWait = 3600.0;        // [s]

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

}  // namespace

ShelfDesk::ShelfDesk(TakeShelf& shelf, ExportDesk& exports, OpenTake open, TakeEdited edited)
    : shelf_(shelf),
      exports_(exports),
      open_(std::move(open)),
      answers_(shelf, std::move(edited)),
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
    open_({text->begin(), text->end()}, request, reply);
}

HttpAnswer ShelfDesk::answer(const ShelfRequest& request) {
    switch (request.action) {
        case ShelfAction::BeginExport:
            return beginExport(request);
        case ShelfAction::ShowExport:
            return showExport(request, false);
        case ShelfAction::CancelExport:
            return doneAnswer(exports_.cancel(request.name));
        case ShelfAction::DownloadExport:
            return showExport(request, true);
        default:
            return answers_.answer(request);
    }
}

HttpAnswer ShelfDesk::beginExport(const ShelfRequest& request) {
    auto order = readExportOrder({request.body.begin(), request.body.end()}, shelf_);
    if (!order.ok()) return failure(order.status());
    const auto number = exports_.begin(std::move(order).value());
    return number.ok() ? jsonAnswer({{"number", *number}}) : failure(number.status());
}

HttpAnswer ShelfDesk::showExport(const ShelfRequest& request, bool asFile) {
    const auto report = exports_.report(request.name);
    if (!report.ok()) return failure(report.status());
    if (asFile) {
        if (report->path.empty()) return sentence(404, "The export is not done.");
        return fileAnswer(report->path, "application/octet-stream", report->fileName);
    }
    Json value = {{"state", nameOf(report->state)}, {"share", report->share}, {"file", report->fileName}};
    value["bytes"] = report->bytes;
    value["people"] = report->people;
    if (!report->problem.empty()) value["problem"] = report->problem;
    return jsonAnswer(value);
}

}  // namespace muster
