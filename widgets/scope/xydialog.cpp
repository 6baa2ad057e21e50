// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/xydialog.h"

#include <QDialogButtonBox>
#include <QLabel>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/scope/xyplot.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
/// More points would make painting, and with it a stop key, wait.
constexpr std::size_t kMostPoints = 10'000;
}  // namespace

XyDialog::XyDialog(QWidget* parent)
    : StretchDialog(u"xyDialog"_s, tr("One signal over another, between the cursors"), parent),
      m_x(newBox(u"xyHorizontalBox"_s, tr("Horizontal"), 0)),
      m_y(newBox(u"xyVerticalBox"_s, tr("Vertical"), 1)),
      m_plot(new XyPlot(this)),
      m_hint(form::newParagraph(u"xyHint"_s, {}, this, 1)) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    const auto newRow = [this](const QString& label, TraceBox* box) {
        return form::newLine(this, {form::newLabel(label, box), box, nullptr});
    };
    form::fill(this,
               form::newColumn(this, {newRow(tr("&Horizontal"), m_x), newRow(tr("&Vertical"), m_y),
                                      form::Item(m_plot, 1), m_hint, buttons}),
               1);
}

void XyDialog::showSamples(const std::vector<Samples>& samples) {
    const Samples& x = samples[0];
    const Samples& y = samples[1];
    QString hint = whyNothing(x, 1, kMostPoints);
    if (hint.isEmpty())
        hint = whyNothing(y, 1, kMostPoints);
    look::setText(m_hint, hint);
    m_plot->showCurve(hint.isEmpty() ? xyCurve(x.points, y.points) : std::vector<XyPoint>{},
                      tr("%1 over %2").arg(y.trace.label, x.trace.label));
}

}  // namespace nmc
