// SPDX-License-Identifier: GPL-3.0-or-later
// However many docks are open, and however small the window is: each dock is visible, or a tab of one that
// is, and none covers another, the panel or the bars above.
#include "windowtest.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;

class Docks : public WindowTest, public testing::WithParamInterface<QSize> {
protected:
    [[nodiscard]] QRect place(const QWidget& widget) const {
        return {widget.mapTo(window.get(), QPoint()), widget.size()};
    }
    /// The visible docks, the centre of the window, and the bars above.
    [[nodiscard]] QList<const QWidget*> inSight() const {
        QList<const QWidget*> all{window->centralWidget(), window->menuWidget()};
        for (const QDockWidget* dock : window->findChildren<QDockWidget*>())
            if (dock->isVisible() && !dock->visibleRegion().isEmpty())
                all << dock;
        return all;
    }
    void expectApart() {
        const QList<const QWidget*> all = inSight();
        for (qsizetype i = 0; i < all.size(); ++i)
            for (qsizetype k = 0; k < i; ++k)
                EXPECT_FALSE(place(*all[i]).intersects(place(*all[k])))
                    << all[i]->objectName().toStdString() << " and " << all[k]->objectName().toStdString();
        for (const QWidget* widget : all)
            EXPECT_TRUE(window->rect().contains(place(*widget))) << widget->objectName().toStdString();
    }
    void settle() {
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
    }
};

TEST_P(Docks, NoneCoversAnother) {
    LinkState link = connectedTo({Servo{}.state(), Servo{.index = 1}.state()});
    link.simulated = true;  // with the dock of the simulator
    window->showLink(link);
    window->resize(GetParam());
    settle();
    expectApart();
    for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
        SCOPED_TRACE(dock->objectName().toStdString());
        if (!dock->isVisible())
            dock->toggleViewAction()->trigger();
        dock->raise();
        settle();
        expectApart();
    }
    window->resize(GetParam() / 2);
    settle();
    expectApart();
}

INSTANTIATE_TEST_SUITE_P(At, Docks, testing::Values(QSize(800, 600), QSize(1024, 768), QSize(1500, 1100)),
                         [](const auto& size) { return "W" + std::to_string(size.param.width()); });

class DockKeys : public WindowTest {
protected:
    void strike(Qt::Key key) {
        QTest::keyClick(window.get(), key);
        QCoreApplication::processEvents();
    }
    bool inFront(const QString& dock, const QString& other) {
        const auto seen = [this](const QString& name) {
            return !find<QDockWidget>(name)->visibleRegion().isEmpty();
        };
        return eventually([&] { return seen(dock) && !seen(other); });
    }
};

TEST_F(DockKeys, BringToTheFrontWhatStandsBehind) {
    showServo();
    window->resize(1'500, 1'100);
    strike(Qt::Key_F3);
    strike(Qt::Key_F4);
    EXPECT_TRUE(inFront(u"axesDock"_s, u"sequencesDock"_s));
    strike(Qt::Key_F3);
    EXPECT_TRUE(inFront(u"sequencesDock"_s, u"axesDock"_s));
    QCoreApplication::processEvents();
    strike(Qt::Key_F3);
    EXPECT_FALSE(find<QDockWidget>(u"sequencesDock"_s)->isVisible())
        << "it was in front, so the key closes it";
}

}  // namespace
}  // namespace nmc
