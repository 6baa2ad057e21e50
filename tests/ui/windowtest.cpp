// SPDX-License-Identifier: GPL-3.0-or-later
#include "windowtest.h"

#include "widgets/common/words.h"

namespace nmc {

servo::SetGain someGains() {
    servo::SetGain gains;
    gains.kp = 100;
    gains.kd = 1000;
    gains.ol = 255;
    gains.el = 4000;
    gains.db = 0;
    return gains;
}

ModuleState Servo::state() const {
    ModuleState module;
    module.info = {ModuleIndex(static_cast<std::uint8_t>(index)),
                   BusAddress(static_cast<std::uint8_t>(index + 1)),
                   {ModuleType::Servo, version},
                   bus::GroupPlace{}};
    if (held)
        module.apply(bus::CommandExecuted{
            module.info.index, TimePoint(std::chrono::milliseconds(900)),
            ServoCommand(servo::StopMotor{true, servo::StopManner::Here, Counts(position)})});
    bus::Sample sample;
    sample.module = module.info.index;
    sample.time = TimePoint(std::chrono::milliseconds(1000 + millisecond));
    sample.report.status =
        static_cast<std::uint8_t>((moveDone ? 0x01 : 0) | (power ? 0x08 : 0) | (on ? 0 : 0x10));
    sample.report.position = position;
    sample.report.aux = static_cast<std::uint8_t>(on ? 0x04 : 0);
    sample.report.analog = std::uint8_t(0);
    sample.report.velocity = std::int16_t(0);
    sample.report.home = 0;
    module.apply(sample);
    if (gains)
        module.gains = someGains();
    return module;
}

LinkState connectedTo(std::vector<ModuleState> modules) {
    LinkState link;
    link.phase = LinkPhase::Connected;
    link.port = "/dev/ttyUSB0";
    link.baud = 115200;
    link.modules = std::move(modules);
    return link;
}

QPalette darkPalette() {
    QPalette palette(QColor(0x3A, 0x3D, 0x41), QColor(0x2B, 0x2D, 0x30));
    palette.setColor(QPalette::Base, QColor(0x1E, 0x1F, 0x22));
    return palette;
}

/// Names are the program's, not the window's.
WindowTest::~WindowTest() {
    texts::setModuleNames({});
}

WindowTest::WindowTest() {
    settings.setValue(u"safety/understood"_s, true);
    window = std::make_unique<MainWindow>(settings);
    // Keeps the settings of the axes, as the program does.
    QObject::connect(&window->requests(), &Requests::axisEdited, window.get(),
                     [this](ModuleIndex module, const AxisSettings& edited) {
                         if (machine.axes.size() <= module.value())
                             machine.axes.resize(module.value() + 1U);
                         machine.axes.at(module.value()) = edited;
                         window->showMachine(machine);
                     });
    window->resize(1280, 864);
    window->show();
    window->activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(window.get(), testing_support::kPatienceMs));
}

void WindowTest::showInEveryDock(const ModuleIdentity& identity) {
    ModuleState module = Servo{}.state();
    module.info.identity = identity;
    LinkState link = connectedTo({module});
    link.simulated = true;
    window->showLink(link);
    for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
        dock->show();
        dock->raise();
        QCoreApplication::processEvents();  // some are created when they are shown
    }
}

void WindowTest::showServos(std::vector<Servo> servos) {
    std::vector<ModuleState> modules;
    for (std::size_t i = 0; i < servos.size(); ++i) {
        servos[i].index = static_cast<int>(i);
        modules.push_back(servos[i].state());
    }
    window->showLink(connectedTo(std::move(modules)));
}

QSet<const QWidget*> WindowTest::reachedByTab() {
    constexpr int kMax = 1'000;
    QSet<const QWidget*> reached;
    for (int i = 0; i < kMax; ++i) {
        QTest::keyClick(window->windowHandle(), Qt::Key_Tab);
        const QWidget* focused = QApplication::focusWidget();
        if (focused == nullptr || reached.contains(focused))
            break;
        reached.insert(focused);
    }
    return reached;
}

void WindowTest::pick(const QString& box, const QString& entry) {
    auto* combo = find<QComboBox>(box);
    combo->setFocus();
    QTest::keyClick(combo, Qt::Key_Home);
    while (combo->currentText() != entry && combo->currentIndex() + 1 < combo->count())
        QTest::keyClick(combo, Qt::Key_Down);
    ASSERT_EQ(combo->currentText(), entry);
}

void WindowTest::type(const QString& objectName, const QString& text) {
    NumberField* target = field(objectName);
    target->setFocus();
    target->selectAll();
    if (text.isEmpty())
        QTest::keyClick(target, Qt::Key_Delete);
    for (const QChar c : text)
        QTest::keyClick(target, c.toLatin1());
}

}  // namespace nmc
