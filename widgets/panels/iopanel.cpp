// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/iopanel.h"

#include <QTabWidget>
#include <QVBoxLayout>

#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/panels/counterbox.h"
#include "widgets/panels/iohead.h"
#include "widgets/panels/iovaluesbox.h"
#include "widgets/panels/pinbox.h"

namespace nmc {

using namespace Qt::StringLiterals;

IoPanel::IoPanel(const PanelView& view, Requests& requests) : ModulePage(view, requests) {
    look::name(this, u"ioPanel"_s, tr("I/O module"));
    auto* head = new IoHead(m_context, this);
    auto* pins = new QVBoxLayout;
    pins->addWidget(new PinBox(m_context, this));
    pins->addStretch(1);
    auto* pages = new QTabWidget(this);
    look::name(pages, u"ioPages"_s, Common::tr("Pages of the module"));
    pages->addTab(new IoValuesBox(m_context, this), Common::tr("A/D and PWM"));
    pages->addTab(new CounterBox(m_context, this), tr("Counter"));
    layOut(head, pins, pages);
}

}  // namespace nmc
