// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemView>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <functional>

#include "app/composition.h"
#include "tests/support/nmcsimprocess.h"
#include "tests/support/turnto.h"
#include "widgets/messages/messagelist.h"
#include "widgets/messages/messagerow.h"

namespace nmc::testing_support {

/// The whole program without main(). What a test is about is done by mouse and key; what only leads to it may
/// be asked for in short (ask(), startMoving()).
class IntentPanel {
public:
    /// `settings`: a file; empty for a fresh one. `data`: where what moves is kept; empty: beside it.
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
    /// Connects, and waits until the modules are there.
    void connectTo(const QString& port) {
        ASSERT_NO_FATAL_FAILURE(askFor(port));
        ASSERT_TRUE(waitFor([&] { return connected(); }));
    }
    /// Types the port and strikes Enter; at 115 200 Bd, unless another rate was chosen.
    void askFor(const QString& port) {
        if (m_composition.worker().isOpen())
            disconnect();
        auto* box = window().findChild<QComboBox*>(QStringLiteral("portBox"));
        ASSERT_TRUE(waitFor([&] { return box->isEnabled(); }));
        box->lineEdit()->selectAll();
        QTest::keyClicks(box, port);
        QTest::keyClick(box, Qt::Key_Return);
    }
    /// And stops what moves, if that is asked.
    void disconnect() {
        click("disconnectButton");
        if (auto* stop = window().findChild<QAbstractButton*>(QStringLiteral("stopAndCloseButton")))
            QTest::mouseClick(stop, Qt::LeftButton);
    }
    void click(const char* name) {
        QAbstractButton* button = nullptr;
        ASSERT_NO_FATAL_FAILURE(reach(name, button));
        QTest::mouseClick(button, Qt::LeftButton);
    }
    /// In sight and enabled: nobody clicks on what is hidden, and a mouse click there would fall on something
    /// else.
    void reach(const char* name, QAbstractButton*& button) {
        button = window().findChild<QAbstractButton*>(QLatin1String(name));
        ASSERT_NE(button, nullptr) << name;
        ASSERT_TRUE(waitFor([&] {
            turnTo(*button);
            return button->visibleRegion().contains(button->rect().center());
        })) << name;
        ASSERT_TRUE(waitFor([&] { return button->isEnabled(); })) << name << button->toolTip().toStdString();
    }
    /// How often a look has found one: the phase in between may be over before it is seen.
    [[nodiscard]] int chainsFound() const { return m_chainsFound; }
    [[nodiscard]] bool connected() const {
        return m_composition.store().link().phase == LinkPhase::Connected;
    }
    /// As an operator would: chooses the servo, types gains that hold the simulator's motor, applies them,
    /// and enables it.
    void makeReady(std::uint8_t index = 0) {
        auto* list = window().findChild<QAbstractItemView*>(QStringLiteral("chainList"));
        const QModelIndex row = list->model()->index(index, 0);
        list->scrollTo(row);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(row).center());
        const std::pair<const char*, int> gains[] = {{"kpField", 200},   {"kdField", 2'000}, {"kiField", 20},
                                                     {"ilField", 200},   {"olField", 255},   {"clField", 0},
                                                     {"elField", 8'000}, {"srField", 1},     {"dbField", 0}};
        for (const auto& [name, value] : gains) {
            auto* field = window().findChild<QLineEdit*>(QLatin1String(name));
            ASSERT_NE(field, nullptr) << name;
            turnTo(*field);
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, QString::number(value));
        }
        ASSERT_NO_FATAL_FAILURE(click("applyGainsButton"));
        ASSERT_NO_FATAL_FAILURE(click("enableButton"));
        ASSERT_TRUE(waitFor([&] { return m_composition.store().module(ModuleIndex(index))->servoOn(); }));
    }
    /// Connects to the first of two modules and sets it going.
    template <typename Simulator>
    void startMoving(Simulator& sim) {
        m_composition.show({sim.terminal(), 115'200, false});
        ASSERT_TRUE(waitFor([&] { return connected() && module().activity() != Activity::Unknown; }));
        ask(intent::ApplyGains{{200, 2'000, 20, 200, 255, 0, 8'000, 1, std::uint8_t{0}}});
        ASSERT_TRUE(waitFor([&] { return module().gains.has_value(); }));
        ask(intent::Enable{});
        ASSERT_TRUE(waitFor([&] { return module().servoOn(); }));
        ask(intent::Move{
            servomotion::VelocityProfile{CountsPerTick(8 << 16), CountsPerTickSquared(1'311), false}});
        ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::AtSpeed; }));
    }
    template <typename Predicate>
    bool waitFor(Predicate predicate) {
        return wait(predicate);
    }
    /// The first module has answered for so much longer: what was on its way to it has come.
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
    /// As if the control of the first module that asks for it had been used.
    void ask(const Intent& intent) { emit window().intentRequested(ModuleIndex(0), intent); }

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

    /// What was told and is not over; empty: no such message.
    [[nodiscard]] const MessageRow* standing(const QString& words) {
        for (const MessageRow* row : window().findChild<MessageList*>()->rows())
            if (!row->over() && row->message().headline.contains(words))
                return row;
        return nullptr;
    }
    /// Presses the button of a message, as a person does. False when there is none.
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

    [[nodiscard]] const ModuleState& module() const { return *m_composition.store().module(ModuleIndex(0)); }
    MainWindow& window() { return m_composition.window(); }
    Composition& composition() { return m_composition; }
    QSettings& settings() { return m_settings; }

protected:
    /// Until that holds. False: not within 20 seconds.
    virtual bool wait(const std::function<bool()>& predicate) { return QTest::qWaitFor(predicate, 20'000); }

private:
    QTemporaryDir m_directory;
    QSettings m_settings;
    Composition m_composition;
    int m_chainsFound = 0;
};

/// Module 1 of a simulator is on its way.
template <typename Simulator>
bool moves(Simulator& sim) {
    return std::abs(sim.state(1)[QStringLiteral("command_velocity")].toDouble()) > 0.01;
}

}  // namespace nmc::testing_support
