// SPDX-License-Identifier: GPL-3.0-or-later
// The wheel over controls that have a value, with events as they come from the system: they may set the
// focus, and are passed on to the parents.
#include "widgets/chain/chainmenu.h"
#include "windowtest.h"

namespace nmc {
namespace {

class Wheel : public WindowTest {
protected:
    Wheel() {
        window->resize(1600, 1200);
        showServo();
    }
    static void wheel(QWidget* over, int notches = -1) {
        QWidget* top = over->window();
        const QPointF at = over->mapTo(top, over->visibleRegion().boundingRect().center());
        QWheelEvent event(at, top->mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QSpontaneKeyEvent::setSpontaneous(&event);
        qApp->notify(top->windowHandle(), &event);  // sendEvent() would mark it as not coming from the system
    }
    void turnTo(const QString& page) {
        auto* tabs = find<QTabWidget>(u"servoPages"_s);
        for (int i = 0; i < tabs->count(); ++i)
            if (tabs->tabText(i) == page)
                QTest::mouseClick(tabs->tabBar(), Qt::LeftButton, {}, tabs->tabBar()->tabRect(i).center());
        QApplication::processEvents();
    }
    QSignalSpy intents{&window->requests(), &Requests::intent};
};

TEST_F(Wheel, MakesNoOutputOfALimitPin) {
    turnTo(u"Limits && I/O"_s);
    auto* use = find<QComboBox>(u"limit1UseBox"_s);
    ASSERT_TRUE(use->isVisible());
    wheel(use);
    wheel(use);
    EXPECT_EQ(use->currentIndex(), 0);
    EXPECT_FALSE(use->hasFocus());
    EXPECT_EQ(intents.size(), 0);
    QTest::keyClick(use, Qt::Key_Escape);
    use->setFocus(Qt::TabFocusReason);
    wheel(use);
    EXPECT_EQ(intents.size(), 1) << "with the focus, it works as usual";
}

TEST_F(Wheel, ChangesNoBoxWithoutTheFocusOnAnyPage) {
    auto* tabs = find<QTabWidget>(u"servoPages"_s);
    int seen = 0;
    for (int page = 0; page < tabs->count(); ++page) {
        turnTo(tabs->tabText(page));
        for (QComboBox* box : window->findChildren<QComboBox*>()) {
            if (box->visibleRegion().isEmpty() || box->count() < 2)
                continue;
            ++seen;
            for (const int notches : {1, -1}) {
                const int before = box->currentIndex();
                wheel(box, notches);
                EXPECT_EQ(box->currentIndex(), before) << box->objectName().toStdString();
                EXPECT_FALSE(box->hasFocus()) << box->objectName().toStdString();
            }
        }
    }
    EXPECT_GT(seen, 5);
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(Wheel, ChangesNoGroup) {
    QSignalSpy changes(&window->requests(), &Requests::groupChange);
    ModuleState module = Servo{}.state();
    module.info.group = bus::GroupPlace{0xFF, false};
    window->showLink(connectedTo({module}));
    window->findChild<QAction*>(u"groupsAction"_s)->trigger();
    auto* box = find<QComboBox>(u"group1Box"_s);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(box->window(), testing_support::kPatienceMs));
    find(u"chainPagesBar"_s)->setFocus();
    wheel(box);
    EXPECT_EQ(changes.size(), 0);
    EXPECT_FALSE(box->hasFocus());
}

TEST_F(Wheel, OverABoxScrollsThePage) {
    window->resize(800, 600);
    QApplication::processEvents();
    auto* bar = find<QScrollArea>(u"panelScroll"_s)->verticalScrollBar();
    auto* box = find<QComboBox>(u"goalKindBox"_s);
    ASSERT_GT(bar->maximum(), 0);
    ASSERT_FALSE(box->visibleRegion().isEmpty());
    wheel(box);
    EXPECT_GT(bar->value(), 0);
    EXPECT_EQ(box->currentIndex(), 0);
}

}  // namespace
}  // namespace nmc
