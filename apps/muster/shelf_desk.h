// Answers requests to the shelf of takes and to exports, on a thread of its own.
#pragma once

#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "export_desk.h"
#include "mailbox.h"
#include "shelf_answers.h"
#include "shelf_request.h"
#include "studio_server.h"
#include "take_shelf.h"

namespace muster {

/// The shelf's answers. post() may be called from any thread.
class ShelfDesk {
public:
    /// Opens a take's bytes in the session, by its name, and answers the request.
    using OpenTake = std::function<void(std::vector<std::uint8_t> bytes, const ShelfRequest&,
                                        HttpReply reply)>;
    using TakeEdited = ShelfAnswers::TakeEdited;

    /// All must outlive this.
    ShelfDesk(TakeShelf& shelf, ExportDesk& exports, OpenTake open, TakeEdited edited);
    ~ShelfDesk();
    ShelfDesk(const ShelfDesk&) = delete;
    ShelfDesk& operator=(const ShelfDesk&) = delete;

    /// Answers later. False where too much waits.
    bool post(ShelfRequest request, HttpReply reply);

private:
    struct Post {
        ShelfRequest request;
        HttpReply reply;
        bool end = false;
    };
    void run();
    HttpAnswer answer(const ShelfRequest& request);
    HttpAnswer beginExport(const ShelfRequest& request);
    HttpAnswer showExport(const ShelfRequest& request, bool file);
    void open(const ShelfRequest& request, const HttpReply& reply);

    TakeShelf& shelf_;
    ExportDesk& exports_;
    OpenTake open_;
    ShelfAnswers answers_;
    Mailbox<Post> mailbox_;
    std::thread thread_;  // The last member, because the thread uses the others.
};

}  // namespace muster
