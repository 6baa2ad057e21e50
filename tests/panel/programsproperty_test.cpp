// SPDX-License-Identifier: GPL-3.0-or-later
// Programs, the user and a noisy line in any order: no motor moves that nobody with the right to has moved,
// and every stop acts. The oracle is what the simulator knows about the motors.
#include <map>
#include <memory>
#include <optional>
#include <random>

#include "link/api/apiserver.h"
#include "link/clock.h"
#include "tests/support/campaign.h"
#include "tests/support/gains.h"
#include "tests/support/otherprogram.h"
#include "tests/support/virtualpanel.h"
#include "widgets/common/requests.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using testing_support::OtherProgram;
using testing_support::RuntimeFolder;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;
using Json = OtherProgram::Json;

constexpr int kModules = 2;
constexpr int kPrograms = 3;
constexpr int kUser = -1;
constexpr int kActs = 30;
/// From the fastest move here to rest takes less than a second; a noisy line may cost as much again.
constexpr Duration kToRest = std::chrono::seconds(2);

class ProgramsProperty : public testing::TestWithParam<unsigned> {
protected:
    void SetUp() override {
        panel.composition().show(
            {.port = sim.terminal(), .baud = 115'200, .programs = Start::Programs::LetIn});
        ASSERT_TRUE(panel.waitFor([&] { return panel.connected(); }));
        for (std::uint8_t i = 0; i < kModules; ++i) {
            const ModuleState& module = *panel.composition().store().module(ModuleIndex(i));
            ASSERT_TRUE(panel.waitFor([&] { return module.activity() != Activity::Unknown; }));
            user(i, intent::ApplyGains{testing_support::kGains});
            ASSERT_TRUE(panel.waitFor([&] { return module.gains.has_value(); }));
            user(i, intent::Enable{});
            ASSERT_TRUE(panel.waitFor([&] { return module.servoOn(); }));
        }
        for (int i = 0; i < kPrograms; ++i)
            connect(i);
        QObject::connect(&panel.composition().store(), &BusStore::happened, &panel.window(),
                         [this](const StoreEvent& event) {
                             stops += std::holds_alternative<bus::StopFinished>(event) ? 1U : 0U;
                         });
    }

    int any(int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); }

    // ---- acts ----

    void connect(int program) {
        programs[program] = std::make_unique<OtherProgram>(panel, ApiServer::pathFor(sim.terminal()));
        ASSERT_NO_FATAL_FAILURE(programs[program]->hello(("program " + std::to_string(program)).c_str()));
    }
    void requestControl(int program) {
        const int asked = programs[program]->request("request_control");
        const bool yes = any(4) != 0;
        const QString name = yes ? u"grantControlButton"_s : u"refuseControlButton"_s;
        if (!inControl) {
            QAbstractButton* button = nullptr;
            ASSERT_TRUE(panel.waitFor(
                [&] { return (button = panel.window().findChild<QAbstractButton*>(name)) != nullptr; }));
            QTest::mouseClick(button, Qt::LeftButton);
        }
        const bool granted = programs[program]->answer(asked)["result"]["granted"].get<bool>();
        EXPECT_EQ(granted, inControl ? *inControl == program : yes);
        if (granted)
            inControl = program;
    }
    void programMoves(int program) {
        const int module = any(kModules);
        const int goal = (any(2) * 2 - 1) * 20'000;
        const Json answer = any(2) == 0
                                ? programs[program]->call("move", {{"axis", module + 1}, {"to", goal}})
                                : programs[program]->call("move_by", {{"axis", module + 1}, {"by", goal}});
        if (answer.contains("result")) {
            EXPECT_EQ(inControl, program) << "it has no right to";
        } else if (answer["error"]["data"]["reason"] == "NoControl") {
            EXPECT_NE(inControl, program) << "it has the right to";
        }
        if (answer.contains("result"))
            movedBy[module] = program;
    }
    void programJogs(int program) {
        const int module = any(kModules);
        for (int i = 0; i < 5; ++i) {
            if (programs[program]->call("jog", {{"axis", module + 1}, {"velocity", 2}}).contains("result")) {
                EXPECT_EQ(inControl, program) << "it has no right to";
                movedBy[module] = program;
                wait(50);
            }
        }
        if (movedBy.contains(module) && movedBy[module] == program && inControl == program)
            end(module);
    }
    void user(std::uint8_t module, const Intent& intent) {
        emit panel.window().requests().intent(ModuleIndex(module), intent);
        inControl.reset();
    }
    void userMoves() {
        const int module = any(kModules);
        user(static_cast<std::uint8_t>(module),
             intent::MoveBy{{20'000}, ServoPace{CountsPerTick(8 << 16), CountsPerTickSquared(1'311)}});
        movedBy[module] = kUser;
    }
    void stopAll(int who) {
        if (who == kUser) {
            panel.pressStopAll();
        } else {
            EXPECT_EQ(programs[who]->call("stop")["result"]["sent"], true);
        }
        inControl.reset();
        for (int module = 0; module < kModules; ++module)
            end(module);
        // Who gets control before the stop has ended loses it then.
        const unsigned before = stops;
        ASSERT_TRUE(panel.waitFor([&] {
            look();
            return stops > before;
        }));
    }
    void vanish(int program) {
        programs[program]->vanish();
        if (inControl == program)
            inControl.reset();
        for (int module = 0; module < kModules; ++module)
            if (movedBy.contains(module) && movedBy[module] == program)
                end(module);
        wait(50);
        connect(program);
    }
    void act() {
        const int program = any(kPrograms);
        switch (any(10)) {
            case 0:
            case 1:
                return requestControl(program);
            case 2:
            case 3:
            case 4:
                return programMoves(program);
            case 5:
                return programJogs(program);
            case 6:
                return userMoves();
            case 7:
                return stopAll(any(2) == 0 ? kUser : program);
            case 8:
                return vanish(program);
            default:
                return sim.tell("fault bus flip p=0.02 n=10");
        }
    }

    // ---- the oracle ----

    /// Nobody wants this module to move any more.
    void end(int module) {
        movedBy.erase(module);
        restsFrom[module] = monotonicNow() + kToRest;
    }
    void wait(int milliseconds) {
        const TimePoint until = monotonicNow() + std::chrono::milliseconds(milliseconds);
        ASSERT_TRUE(panel.waitFor([&] {
            look();
            return monotonicNow() >= until;
        }));
    }
    void look() {
        for (int module = 0; module < kModules; ++module) {
            if (!movedBy.contains(module) && monotonicNow() > restsFrom[module]) {
                EXPECT_FALSE(sim.driven(static_cast<std::size_t>(module))) << "module " << module + 1;
            }
        }
    }

    RuntimeFolder runtime;
    VirtualChain sim{u"servo,servo"_s};
    VirtualPanel panel;
    std::mt19937 random{GetParam()};
    std::map<int, std::unique_ptr<OtherProgram>> programs;
    std::optional<int> inControl;  ///< the program that may move motors
    std::map<int, int> movedBy;    ///< module -> the program, or kUser, that has moved it last
    std::map<int, TimePoint> restsFrom;
    unsigned stops = 0;  ///< of all modules, that have ended
};

TEST_P(ProgramsProperty, NothingMovesThatNobodyWithTheRightHasMoved) {
    for (int i = 0; i < kActs && !HasFailure(); ++i) {
        SCOPED_TRACE("seed " + std::to_string(GetParam()) + ", act " + std::to_string(i));
        act();
        wait(any(300));
    }
    stopAll(kUser);
    wait(2'500);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ProgramsProperty,
                         testing::Range(1U,
                                        1U + static_cast<unsigned>(test::campaignSize("NMC_PROGRAMS", 3))));

}  // namespace
}  // namespace nmc
