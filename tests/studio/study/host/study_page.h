// A page of the study without a browser: it exchanges bytes with a host and records what it receives.
#pragma once

#include <doctest.h>

#include <optional>
#include <string>
#include <vector>

#include "muster/session.h"
#include "studio/session/inbox/protocol.h"

namespace muster::testing {

template <class Host>
class StudyPage {
public:
    explicit StudyPage(Host& host) : host_(host), id_(host.connect()) { send(protocol::Hello{"page"}); }

    template <class Message>
    void send(const Message& message) {
        host_.receive(id_, protocol::encode(message));
        poll();
    }
    void sendBytes(const std::vector<std::uint8_t>& bytes) {
        host_.receive(id_, bytes);
        poll();
    }
    void enter(const std::string& token = {}) { send(protocol::EnterStudy{token}); }
    void act(protocol::StudyAct act) { send(protocol::DoInStudy{act}); }
    void leave() { host_.disconnect(id_); }

    /// Answers the form that waits by the least or first answer.
    void answer() {
        REQUIRE(form);
        protocol::AnswerForm message{.instrument = form->instrument};
        for (const protocol::QuestionFrame& question : form->questions) {
            protocol::AnswerFrame answer{question.name, "", question.low};
            if (!question.choices.empty()) answer.text = question.choices[0].text;
            message.answers.push_back(answer);
        }
        form.reset();
        send(message);
    }
    void poll() {
        std::vector<MessageBytes> messages;
        host_.outgoing(id_, messages);
        for (const MessageBytes& bytes : messages) {
            const auto message = protocol::decodeServer(bytes);
            REQUIRE_MESSAGE(message.ok(), message.status().message());
            take(message.value());
        }
    }
    /// The text of the newest notice with that code; empty for none.
    std::string noticed(const std::string& code) const {
        for (auto i = notices.rbegin(); i != notices.rend(); ++i)
            if (i->code == code) return i->text;
        return {};
    }

private:
    void take(const protocol::ServerMessage& message) {
        if (const auto* m = std::get_if<protocol::StudyState>(&message)) states.push_back(*m);
        if (const auto* m = std::get_if<protocol::StudyForm>(&message)) form = *m;
        if (const auto* m = std::get_if<protocol::Scene>(&message)) scenes.push_back(*m);
        if (const auto* m = std::get_if<protocol::Notice>(&message)) notices.push_back(*m);
        if (const auto* m = std::get_if<protocol::Marks>(&message)) marks.push_back(*m);
        if (const auto* m = std::get_if<protocol::Frame>(&message)) {
            frames.push_back(*m);
            host_.receive(id_, protocol::encode(protocol::FrameAck{m->frame}));
        }
    }

    Host& host_;
    std::uint32_t id_;

public:
    std::vector<protocol::StudyState> states;
    std::optional<protocol::StudyForm> form;
    std::vector<protocol::Scene> scenes;
    std::vector<protocol::Frame> frames;
    std::vector<protocol::Marks> marks;
    std::vector<protocol::Notice> notices;
    protocol::StudyStage stage() const {
        return states.empty() ? protocol::StudyStage::Form : states.back().stage;
    }
};

}  // namespace muster::testing
