// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

// Precompiled for the tests of the panel, so that what they need of Qt is included here only.
#include <QtTest>
#include <QtWidgets>
#include <functional>
#include <stdexcept>
#include <string>

#include "app/composition.h"
#include "tests/support/eventually.h"
#include "tests/support/nmcsimprocess.h"
#include "tests/support/turnto.h"
#include "widgets/common/requests.h"
#include "widgets/messages/messagelist.h"
#include "widgets/messages/messagerow.h"

namespace nmc::testing_support {

/// The whole program without main(). A test does what it is about with mouse and keys; what merely leads up
/// to it may be requested directly (ask(), startMoving()).
class IntentPanel {
public:
    /// `settings`: a file; if empty, a new one. `data`: directory of the files that say which motors move; if
    /// empty, that of the settings.
    explicit IntentPanel(const QString& settings = {}, PortController::Places places = {},
                         const QString& data = {}, const FileWriter::Disk& disk = writeFile)
        : m_settings(settings.isEmpty() ? m_directory.filePath(QStringLiteral("panel.ini")) : settings,
                     QSettings::IniFormat),
          m_composition(m_settings, std::move(places), data, disk) {
        QObject::connect(&m_composition.store(), &BusStore::happened, &m_composition.store(),
                         [this](const StoreEvent& event) {
                             m_chainsFound += std::holds_alternative<bus::ChainFound>(event) ? 1 : 0;
                         });
    }

    virtual ~IntentPanel() = default;

    void start() { m_composition.show({}); }
    /// Starts at a chain, and waits until the state of its first module is known.
    void startAt(const QString& port) {
        m_composition.show({port, 115'200, false});
        ASSERT_TRUE(waitFor([&] { return connected() && module().activity() != Activity::Unknown; }));
    }
    /// Connects, and waits until the modules have been found.
    void connectTo(const QString& port) {
        ASSERT_NO_FATAL_FAILURE(askFor(port));
        ASSERT_TRUE(waitFor([&] { return connected(); }));
    }
    /// Disconnects if connected, types the port and presses Enter. The rate is 115 200 Bd unless another one
    /// was chosen.
    void askFor(const QString& port) {
        if (m_composition.worker().isOpen())
            disconnect();
        auto* box = window().findChild<QComboBox*>(QStringLiteral("portBox"));
        ASSERT_TRUE(waitFor([&] { return box->isEnabled(); }));
        box->lineEdit()->selectAll();
        QTest::keyClicks(box, port);
        QTest::keyClick(box, Qt::Key_Return);
    }
    /// Motors that move are stopped if the program asks.
    void disconnect() {
        click("disconnectButton");
        if (auto* stop = window().findChild<QAbstractButton*>(QStringLiteral("stopAndCloseButton")))
            QTest::mouseClick(stop, Qt::LeftButton);
    }
    /// The control with this name, on the page that is shown for it.
    template <typename Widget = QWidget>
    Widget& find(const char* name) {
        auto* widget = window().findChild<Widget*>(QLatin1String(name));
        if (widget == nullptr)
            throw std::runtime_error(std::string("there is no ") + name);
        turnTo(*widget);
        return *widget;
    }
    /// Types over what is in the field.
    void type(const char* field, const QString& text) {
        auto& edit = find<QLineEdit>(field);
        edit.setFocus();
        edit.selectAll();
        QTest::keyClicks(&edit, text);
        EXPECT_EQ(edit.text(), text) << field << " enabled: " << edit.isEnabled();
    }
    /// Selects a module in the list of the chain.
    void select(int row) {
        auto& list = find<QAbstractItemView>("chainList");
        list.setCurrentIndex(list.model()->index(row, 0));
    }
    void click(const char* name) {
        QAbstractButton* button = nullptr;
        ASSERT_NO_FATAL_FAILURE(reach(name, button));
        QTest::mouseClick(button, Qt::LeftButton);
    }
    /// Finds the button and waits until it is visible and enabled: a user cannot click a hidden one, and a
    /// simulated click there would hit something else.
    void reach(const char* name, QAbstractButton*& button) {
        button = window().findChild<QAbstractButton*>(QLatin1String(name));
        ASSERT_NE(button, nullptr) << name;
        ASSERT_TRUE(waitFor([&] {
            turnTo(*button);
            return button->visibleRegion().contains(button->rect().center());
        })) << name;
        ASSERT_TRUE(waitFor([&] { return button->isEnabled(); })) << name << button->toolTip().toStdString();
    }
    /// Number of searches that have found a chain. A test may miss the phase in between.
    [[nodiscard]] int chainsFound() const { return m_chainsFound; }
    [[nodiscard]] bool connected() const {
        return m_composition.store().link().phase == LinkPhase::Connected;
    }
    /// Selects the servo, types gains that hold the simulator's motor, applies them, and enables it, as an
    /// operator would.
    void makeReady(std::uint8_t index = 0) {
        auto* list = window().findChild<QAbstractItemView*>(QStringLiteral("chainList"));
        const QModelIndex row = list->model()->index(index, 0);
        list->scrollTo(row);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(row).center());
        const std::pair<const char*, int> gains[] = {{"kpField", 200},   {"kdField", 2'000}, {"kiField", 20},
                                                     {"ilField", 200},   {"olField", 255},   {"clField", 0},
                                                     {"elField", 8'000}, {"srField", 1},     {"dbField", 0}};
        for (const auto& [name, value] : gains)
            type(name, QString::number(value));
        ASSERT_NO_FATAL_FAILURE(click("applyGainsButton"));
        ASSERT_NO_FATAL_FAILURE(click("enableButton"));
        ASSERT_TRUE(waitFor([&] { return module(index).servoOn(); }));
    }
    /// Moves the selected servo, as an operator would.
    void goTo(int counts) {
        type("goalField", QString::number(counts));
        type("velocityField", QStringLiteral("8"));
        type("accelerationField", QStringLiteral("0.02"));
        click("goButton");
    }
    /// Enables the first servo, with gains that hold the simulator's motor.
    void enable(std::uint16_t positionErrorLimit = 8'000) {
        ask(intent::ApplyGains{{200, 2'000, 20, 200, 255, 0, positionErrorLimit, 1, std::uint8_t{0}}});
        ASSERT_TRUE(waitFor([&] { return module().gains.has_value(); }));
        ask(intent::Enable{});
        ASSERT_TRUE(waitFor([&] { return module().servoOn(); }));
    }
    /// Connects to a simulator and runs its first module in velocity mode.
    template <typename Simulator>
    void startMoving(Simulator& sim) {
        ASSERT_NO_FATAL_FAILURE(startAt(sim.terminal()));
        setGoing();
    }
    /// Runs the first module in velocity mode.
    void setGoing() {
        ASSERT_NO_FATAL_FAILURE(enable());
        ask(intent::Move{
            servomotion::VelocityProfile{CountsPerTick(8 << 16), CountsPerTickSquared(1'311), false}});
        ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::AtSpeed; }));
    }
    template <typename Predicate>
    bool waitFor(Predicate predicate) {
        return wait(predicate);
    }
    /// Waits until the first module has answered for this much longer, so that whatever was on its way to it
    /// has arrived.
    bool answersFor(double seconds) {
        const ModuleState* first = m_composition.store().module(ModuleIndex(0));
        if (first == nullptr)
            return false;
        const TimePoint until = first->latestTime + fromSeconds(seconds);
        return waitFor([&] {
            const ModuleState* now = m_composition.store().module(ModuleIndex(0));
            return now != nullptr && now->latestTime >= until;
        });
    }
    /// Has the effect of the control on the page of the first module that requests this.
    void ask(const Intent& intent) { emit window().requests().intent(ModuleIndex(0), intent); }

    /// Headlines of the message list, newest first.
    [[nodiscard]] QStringList headlines() {
        QStringList lines;
        for (const MessageRow* row : window().findChild<MessageList*>()->rows())
            lines << row->message().headline;
        return lines;
    }
    [[nodiscard]] int count(const QString& words) {
        return static_cast<int>(headlines().filter(words).size());
    }

    /// The message with these words that has not ended; null if there is none.
    [[nodiscard]] const MessageRow* standing(const QString& words) {
        for (const MessageRow* row : window().findChild<MessageList*>()->rows())
            if (!row->over() && row->message().headline.contains(words))
                return row;
        return nullptr;
    }
    /// Presses the button of a message, as a user does. False if there is none.
    bool press(const QString& headline, const QString& button) {
        const MessageRow* row = standing(headline);
        if (row == nullptr)
            return false;
        for (auto* candidate : row->findChildren<QPushButton*>())
            if (candidate->text().contains(button)) {
                QTest::mouseClick(candidate, Qt::LeftButton);
                return true;
            }
        return false;
    }
    void pressStopAll() {
        QTest::mouseClick(window().findChild<QWidget*>(QStringLiteral("stopAllButton")), Qt::LeftButton);
    }
    /// The files that say which motors move, beside the settings.
    [[nodiscard]] QStringList markers() const {
        return QFileInfo(m_settings.fileName()).dir().entryList({QStringLiteral("moving-*.json")});
    }

    [[nodiscard]] const ModuleState& module(std::uint8_t index = 0) const {
        return *m_composition.store().module(ModuleIndex(index));
    }
    MainWindow& window() { return m_composition.window(); }
    Composition& composition() { return m_composition; }
    QSettings& settings() { return m_settings; }

protected:
    /// Waits until `predicate` holds; false if it never does.
    virtual bool wait(const std::function<bool()>& predicate) { return eventually(predicate); }

private:
    QTemporaryDir m_directory;
    QSettings m_settings;
    Composition m_composition;
    int m_chainsFound = 0;
};

/// True if module 1 of a simulator is moving.
template <typename Simulator>
bool moves(Simulator& sim) {
    return std::abs(sim.state(1)[QStringLiteral("command_velocity")].toDouble()) > 0.01;
}

}  // namespace nmc::testing_support
