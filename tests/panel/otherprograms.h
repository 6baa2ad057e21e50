// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QLabel>
#include <QtTest>

#include "link/api/apiserver.h"
#include "tests/support/otherprogram.h"
#include "tests/support/virtualpanel.h"
#include "tests/support/virtualtime.h"

namespace nmc::testing_support {

/// Other programs at the panel's socket (docs/api.md): they are let in, and none is connected yet. The oracle
/// is what the simulator knows about the motors.
class OtherPrograms : public testing::Test {
protected:
    using Json = OtherProgram::Json;

    explicit OtherPrograms(const QString& chain = QStringLiteral("servo,servo")) : sim{chain} {}
    void SetUp() override {
        panel.composition().show({.port = sim.terminal(), .baud = 115'200});
        ASSERT_TRUE(panel.waitFor([&] { return panel.connected(); }));
        panel.window().findChild<QAction*>(QStringLiteral("letProgramsInAction"))->trigger();
        ASSERT_TRUE(panel.waitFor([&] { return QFile::exists(path()); }));
    }
    [[nodiscard]] QString path() const { return ApiServer::pathFor(sim.terminal()); }
    /// A click of the user on the question.
    void decide(const char* button) {
        ASSERT_TRUE(panel.waitFor(
            [&] { return panel.window().findChild<QAbstractButton*>(QLatin1String(button)) != nullptr; }));
        QTest::mouseClick(panel.window().findChild<QAbstractButton*>(QLatin1String(button)), Qt::LeftButton);
    }
    void control(OtherProgram& client, const Json& parameters = Json::object()) {
        const int asked = client.request("request_control", parameters);
        ASSERT_NO_FATAL_FAILURE(decide("grantControlButton"));
        ASSERT_EQ(client.answer(asked)["result"]["granted"], true);
    }
    /// The program has introduced itself and may move motors; motor 1 holds.
    void ready(OtherProgram& client) {
        client.hello();
        ASSERT_NO_FATAL_FAILURE(control(client));
        ASSERT_NO_FATAL_FAILURE(enable(client, 1));
    }
    /// This motor holds, too.
    void enable(OtherProgram& client, int axis) {
        Json gains = kGains;
        gains["axis"] = axis;
        ASSERT_EQ(client.call("set_gains", gains)["result"]["accepted"], true);
        ASSERT_TRUE(client.call("wait", {{"axis", axis}}).contains("result"));
        ASSERT_EQ(client.call("enable", {{"axis", axis}})["result"]["accepted"], true);
        ASSERT_TRUE(client.call("wait", {{"axis", axis}}).contains("result"));
    }
    /// Motor 1 is on its way to a distant place.
    void setGoing(OtherProgram& client) {
        ASSERT_NO_FATAL_FAILURE(ready(client));
        EXPECT_EQ(client.call("move", {{"axis", 1}, {"to", 1'000'000}})["result"]["accepted"], true);
        ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    }
    [[nodiscard]] QString ribbon() {
        return panel.window().findChild<QLabel*>(QStringLiteral("programsRibbonText"))->text();
    }

    const Json kGains{{"axis", 1}, {"kp", 200}, {"kd", 2'000}, {"ki", 20}, {"il", 200},
                      {"ol", 255}, {"cl", 0},   {"el", 8'000}, {"sr", 1}};
    RuntimeFolder runtime;
    VirtualChain sim;
    VirtualPanel panel;
};

}  // namespace nmc::testing_support
