// SPDX-License-Identifier: GPL-3.0-or-later
// The program's main job, through its window and by object name: find a chain, set gains, enable, set out
// for a position, and stop with Esc - on the simulator in this process, and over a pseudo-terminal that
// nmcsim serves.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "app/composition.h"
#include "tests/support/eventually.h"
#include "tests/support/nmcsimprocess.h"
#include "tests/support/turnto.h"
#include "widgets/messages/messagelist.h"
#include "widgets/messages/messagerow.h"

namespace nmc {
namespace {

using testing_support::NmcsimProcess;

/// The whole program without main(), with its own settings.
class Panel {
public:
    Panel()
        : m_settings(m_directory.filePath(QStringLiteral("panel.ini")), QSettings::IniFormat),
          m_composition(m_settings) {}

    void start(const QString& port, std::uint32_t baud) { m_composition.show({port, baud, false}); }

    template <typename Widget = QWidget>
    Widget& find(const char* name) {
        auto* widget = m_composition.window().findChild<Widget*>(QLatin1String(name));
        if (widget == nullptr)
            throw std::runtime_error(std::string("there is no ") + name);
        testing_support::turnTo(*widget);
        return *widget;
    }
    void type(const char* field, const QString& text) {
        auto& edit = find<QLineEdit>(field);
        edit.setFocus();
        edit.selectAll();
        QTest::keyClicks(&edit, text);
        EXPECT_EQ(edit.text(), text) << field << " visible " << edit.isVisible() << " enabled "
                                     << edit.isEnabled();
    }
    void click(const char* button) {
        auto& widget = find<QAbstractButton>(button);
        ASSERT_TRUE(widget.isEnabled()) << button << ": " << widget.toolTip().toStdString();
        QTest::mouseClick(&widget, Qt::LeftButton);
    }
    bool waitUntilEnabled(const char* button) {
        return waitFor([&] { return find<QAbstractButton>(button).isEnabled(); });
    }
    void selectModule(int row) {
        auto& list = find<QAbstractItemView>("chainList");
        list.setCurrentIndex(list.model()->index(row, 0));
    }
    template <typename Predicate>
    bool waitFor(Predicate predicate) {
        return testing_support::eventually(predicate);
    }
    [[nodiscard]] std::size_t modules() const { return m_composition.store().link().modules.size(); }
    [[nodiscard]] const ModuleState& module(std::uint8_t index) const {
        return *m_composition.store().module(ModuleIndex(index));
    }
    [[nodiscard]] bool found(std::size_t count) const {
        return m_composition.store().link().phase == LinkPhase::Connected && modules() == count;
    }
    [[nodiscard]] bool tells(const char* words) {
        for (const MessageRow* row : window().findChild<MessageList*>()->rows())
            if (row->message().headline.contains(QLatin1String(words)))
                return true;
        return false;
    }
    MainWindow& window() { return m_composition.window(); }

    void setGainsAndEnable() {
        const std::pair<const char*, int> gains[] = {{"kpField", 200},   {"kdField", 2'000}, {"kiField", 0},
                                                     {"ilField", 0},     {"olField", 255},   {"clField", 0},
                                                     {"elField", 8'000}, {"srField", 1},     {"dbField", 0}};
        for (const auto& [field, value] : gains)
            type(field, QString::number(value));
        ASSERT_TRUE(waitUntilEnabled("applyGainsButton"))
            << find<QAbstractButton>("applyGainsButton").toolTip().toStdString();
        click("applyGainsButton");
        ASSERT_TRUE(waitUntilEnabled("enableButton"));
        click("enableButton");
        ASSERT_TRUE(waitUntilEnabled("goButton"));
    }
    void goTo(int counts) {
        type("goalField", QString::number(counts));
        type("velocityField", QStringLiteral("8"));
        type("accelerationField", QStringLiteral("0.02"));
        click("goButton");
    }
    /// Moves so far, at 8 counts/tick and 0.02 counts/tick^2, that no pause of this computer brings it to its
    /// goal, and stops it with Esc. That a motor reaches its goal is tested where no guardian can stop it
    /// because this computer gave the panel no time (tests/panel, SerialPath).
    void moveAndStop() {
        goTo(-40'000'000);
        ASSERT_TRUE(waitFor([&] { return *module(1).latest->position < -50; }));
        QTest::keyClick(&find<QLineEdit>("goalField"), Qt::Key_Escape);
        ASSERT_TRUE(waitFor([&] {
            return find<QLabel>("stopResultLabel").text().contains(QLatin1String("stopped and holding"));
        }));
        ASSERT_TRUE(waitFor([&] { return module(1).activity() == Activity::Holding; }));
        EXPECT_GT(*module(1).latest->position, -39'000'000);
    }

private:
    QTemporaryDir m_directory;
    QSettings m_settings;
    Composition m_composition;
};

TEST(FirstLight, MovesAMotorOfTheBuiltInSimulator) {
    Panel panel;
    panel.start(QStringLiteral("simulator=servo,servo,servo@1"), 115'200);
    ASSERT_TRUE(panel.waitFor([&] { return panel.found(3); }));
    EXPECT_EQ(panel.module(2).info.identity.version, 1);
    EXPECT_TRUE(panel.window().windowTitle().contains(QLatin1String("Simulator")));
    ASSERT_NO_FATAL_FAILURE(panel.selectModule(1));
    ASSERT_NO_FATAL_FAILURE(panel.setGainsAndEnable());
    panel.moveAndStop();
}

TEST(FirstLightOnATerminal, MovesAMotorWithoutAViolation) {
    NmcsimProcess sim(QStringLiteral("servo,servo,servo@1"));
    Panel panel;
    panel.start(sim.terminal(), 115'200);
    ASSERT_TRUE(panel.waitFor([&] { return panel.found(3); }));
    EXPECT_TRUE(panel.window().windowTitle().startsWith(QLatin1String("NMC Panel")));
    EXPECT_FALSE(panel.window().windowTitle().contains(QLatin1String("Simulator")));
    EXPECT_FALSE(panel.tells("guardian")) << "a guardian that works is not mentioned";
    ASSERT_NO_FATAL_FAILURE(panel.selectModule(1));
    ASSERT_NO_FATAL_FAILURE(panel.setGainsAndEnable());
    panel.moveAndStop();
    const QJsonObject state = sim.state(2);
    EXPECT_TRUE(state[QStringLiteral("servo_on")].toBool());
    EXPECT_EQ(state[QStringLiteral("gains")].toObject()[QStringLiteral("kd")].toInt(), 2'000);
    EXPECT_FALSE(sim.state(1)[QStringLiteral("servo_on")].toBool());
    EXPECT_EQ(sim.violations(), "");
}

}  // namespace
}  // namespace nmc
