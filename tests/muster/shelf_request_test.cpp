#include "shelf_request.h"

#include <doctest.h>

using namespace muster;

TEST_CASE("Only known methods and paths reach the shelf") {
    CHECK(isShelfTarget("/takes"));
    CHECK(isShelfTarget("/takes/a.take?x=1"));
    CHECK(isShelfTarget("/exports/3/file"));
    CHECK_FALSE(isShelfTarget("/take"));
    CHECK_FALSE(isShelfTarget("/takesome"));
    CHECK_FALSE(isShelfTarget("/x/takes"));
    const auto edit = shelfRequest("PATCH", "/takes/a.take");
    REQUIRE(edit);
    CHECK(edit->action == ShelfAction::Edit);
    CHECK(edit->name == "a.take");
    CHECK(shelfRequest("GET", "/takes")->action == ShelfAction::List);
    CHECK(shelfRequest("POST", "/takes")->action == ShelfAction::Put);
    CHECK(shelfRequest("POST", "/takes/a.take/open")->action == ShelfAction::Open);
    CHECK(shelfRequest("PUT", "/takes/a.take/picture")->action == ShelfAction::PutPicture);
    CHECK(shelfRequest("GET", "/exports/7/file")->action == ShelfAction::DownloadExport);
    for (const char* target :
         {"/takes/", "/takes//picture", "/takes/a.take/", "/takes/a.take/picture/", "/takes/a/b/c"})
        CHECK_FALSE(shelfRequest("GET", target));
    CHECK_FALSE(shelfRequest("DELETE", "/takes"));
    CHECK_FALSE(shelfRequest("PUT", "/takes/a.take"));
    CHECK_FALSE(shelfRequest("TRACE", "/takes"));
    CHECK(mostBodyBytes(ShelfAction::Remove, 99) == 0);
    CHECK(mostBodyBytes(ShelfAction::Put, 99) == 99);
    CHECK_FALSE(isReading(ShelfAction::Open));
    CHECK(isReading(ShelfAction::Download));
}
