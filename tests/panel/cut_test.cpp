// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing in the panel of a module is cut off: on every page, in every language, in the window as it first
// opens, and in a small one.
#include "tests/support/virtualpanel.h"
#include "tests/ui/inlanguage.h"
#include "widgets/common/elidedlabel.h"

namespace nmc {
namespace {

using testing_support::VirtualChain;
using testing_support::VirtualPanel;
using namespace Qt::StringLiterals;

struct Shown {
    const char* language;
    QSize size;
};

void PrintTo(const Shown& shown, std::ostream* out) {
    *out << shown.language << ' ' << shown.size.width();
}

/// Names the text that is cut off in this widget, if it is one that should show all of its text.
[[nodiscard]] QString cutIn(const QWidget& widget) {
    QString text;
    if (const auto* label = qobject_cast<const QLabel*>(&widget);
        label != nullptr && !label->wordWrap() && qobject_cast<const ElidedLabel*>(label) == nullptr)
        text = label->text();
    else if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        text = button->text();
    if (text.isEmpty() || widget.sizeHint().width() <= widget.width() + 1)
        return {};
    return u"%1: \"%2\" needs %3 px and has %4"_s.arg(widget.objectName(), text)
        .arg(widget.sizeHint().width())
        .arg(widget.width());
}

class Whole : public testing::TestWithParam<Shown> {
protected:
    [[nodiscard]] static QStringList cut(const QWidget& window) {
        QStringList lines;
        for (const QScrollArea* area : window.findChildren<QScrollArea*>())
            if (area->isVisible() && area->horizontalScrollBar()->isVisible())
                lines << area->objectName() +
                             u": needs %1 px and has %2"_s.arg(area->widget()->minimumSizeHint().width())
                                 .arg(area->viewport()->width());
        for (const QWidget* widget : window.findChildren<QWidget*>())
            if (widget->isVisible())
                if (const QString line = cutIn(*widget); !line.isEmpty())
                    lines << line;
        return lines;
    }

    void SetUp() override {
        panel.window().resize(GetParam().size);
        ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
    }
    void TearDown() override {
        for (const auto& [line, where] : m_first)
            ADD_FAILURE() << line.toStdString() << "; first at " << where.toStdString();
    }

    /// What the last answer changed gets its space only on the next turn of the event loop.
    void wait(double seconds) {
        ASSERT_TRUE(panel.answersFor(seconds));
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    }
    void choose(const QString& layout) {
        panel.window().findChild<QAction*>(layout)->trigger();
        panel.window().resize(GetParam().size);
        ASSERT_TRUE(panel.answersFor(0.5));
    }
    void select(int module) {
        panel.select(module);
        ASSERT_TRUE(panel.answersFor(0.2));
    }
    /// The pages of the selected module.
    [[nodiscard]] QTabWidget* pages() {
        for (QTabWidget* pages : panel.window().findChildren<QTabWidget*>())
            if (pages->isVisible() && pages->objectName().endsWith(u"Pages"_s))
                return pages;
        return nullptr;
    }
    void look(const QString& where) {
        ASSERT_NO_FATAL_FAILURE(wait(0.1));
        for (const QString& line : cut(panel.window()))
            m_first.try_emplace(line, where);
    }
    void lookAtEveryPage() {
        for (int module = 0; module < 4; ++module) {
            ASSERT_NO_FATAL_FAILURE(select(module));
            ASSERT_NE(pages(), nullptr);
            for (int i = 0; i < pages()->count(); ++i) {
                pages()->setCurrentIndex(i);
                ASSERT_NO_FATAL_FAILURE(look(u"module %1, %2"_s.arg(module + 1).arg(pages()->tabText(i))));
            }
        }
    }

    const InLanguage language{GetParam().language};
    VirtualChain sim{u"servo,step,io,servo@10"_s};
    VirtualPanel panel;

private:
    std::map<QString, QString> m_first;  ///< where each line was first found
};

TEST_P(Whole, IsEveryPageOfEveryModule) {
    ASSERT_NO_FATAL_FAILURE(choose(u"operateLayoutAction"_s));
    ASSERT_NO_FATAL_FAILURE(lookAtEveryPage());
}

TEST_P(Whole, IsEveryPageBesideThePlots) {
    ASSERT_NO_FATAL_FAILURE(choose(u"tuneLayoutAction"_s));
    ASSERT_NO_FATAL_FAILURE(lookAtEveryPage());
}

TEST_P(Whole, IsAsBeforeWhenThePlotsAreGone) {
    const auto places = [this] {
        std::map<QString, QRect> all;
        const QWidget* motions = pages()->parentWidget()->findChild<QScrollArea*>(u"panelScroll"_s)->widget();
        for (const QWidget* widget : motions->findChildren<QWidget*>())
            if (!widget->objectName().isEmpty() && widget->isVisible())
                all[widget->objectName()] = {widget->mapTo(motions, QPoint()), widget->size()};
        return all;
    };
    for (const int module : {0, 1}) {
        ASSERT_NO_FATAL_FAILURE(choose(u"operateLayoutAction"_s));
        ASSERT_NO_FATAL_FAILURE(select(module));
        ASSERT_NO_FATAL_FAILURE(wait(0.3));
        const std::map<QString, QRect> before = places();
        ASSERT_NO_FATAL_FAILURE(choose(u"tuneLayoutAction"_s));
        ASSERT_NO_FATAL_FAILURE(wait(0.3));
        EXPECT_NE(places(), before);
        ASSERT_NO_FATAL_FAILURE(choose(u"operateLayoutAction"_s));
        ASSERT_NO_FATAL_FAILURE(wait(0.3));
        EXPECT_EQ(places(), before);
    }
}

/// The safety note and the first steps are open as well: the controls that they lead to must still be
/// visible.
TEST_P(Whole, IsWhatAFirstSessionNeeds) {
    ASSERT_NO_FATAL_FAILURE(choose(u"operateLayoutAction"_s));
    ASSERT_NO_FATAL_FAILURE(select(0));
    ASSERT_NO_FATAL_FAILURE(wait(0.3));
    for (const char* name : {"bannerAction_understood", "firstSteps", "enableButton", "fillGainsButton",
                             "applyGainsButton", "moveByEndButton"}) {
        const auto* widget = panel.window().findChild<QWidget*>(QString::fromLatin1(name));
        EXPECT_EQ(widget->visibleRegion(), QRegion(widget->rect())) << name;
    }
}

TEST_P(Whole, IsEveryDock) {
    ASSERT_NO_FATAL_FAILURE(choose(u"operateLayoutAction"_s));
    for (auto* dock : panel.window().findChildren<QDockWidget*>()) {
        const bool shown = dock->isVisible();
        if (!shown)
            dock->toggleViewAction()->trigger();
        ASSERT_NO_FATAL_FAILURE(look(dock->windowTitle()));
        if (!shown)
            dock->toggleViewAction()->trigger();
    }
}

/// A screen of 1080 lines at 200 % has 540, and a title bar takes some of them.
TEST_P(Whole, IsTheStatusLineOnASmallScreen) {
    for (const QString& layout : {u"operateLayoutAction"_s, u"tuneLayoutAction"_s, u"chainLayoutAction"_s}) {
        ASSERT_NO_FATAL_FAILURE(choose(layout));
        panel.window().resize(960, 510);
        ASSERT_NO_FATAL_FAILURE(wait(0.3));
        EXPECT_LE(panel.window().height(), 510) << layout.toStdString();
        EXPECT_LE(panel.window().width(), 960) << layout.toStdString();
        const QWidget* bar = panel.window().statusBar();
        for (const auto* label : bar->findChildren<QLabel*>())
            if (label->isVisible()) {
                EXPECT_EQ(cutIn(*label).toStdString(), "") << layout.toStdString();
            }
    }
}

INSTANTIATE_TEST_SUITE_P(D21, Whole, testing::ValuesIn([] {
                             std::vector<Shown> shown;
                             for (const char* language : {"en", "de", "fr", "es", "ja"})
                                 for (const QSize size : {QSize{1'280, 800}, QSize{1'456, 952}})
                                     shown.push_back({language, size});
                             return shown;
                         }()));

}  // namespace
}  // namespace nmc
