// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/holdfirstbutton.h"

#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/texts.h"

namespace nmc {

using namespace Qt::StringLiterals;

HoldFirstButton::HoldFirstButton(const QString& objectName, Requests& requests, QWidget* parent)
    : QPushButton(icons::tinted(u"hand-stop"_s), tr("Hold here first"), parent) {
    look::name(this, objectName, tr("Hold here first"));
    look::keepRoom(this);
    setVisible(false);
    connect(this, &QPushButton::clicked, this, [this, &requests] {
        if (m_module)
            emit requests.intent(*m_module, intent::StopHere{});
    });
}

void HoldFirstButton::showFor(const std::optional<ModuleState>& module, std::optional<Refusal> refusal) {
    m_module.reset();
    setVisible(module && refusal == Refusal::CommandUnknown);
    if (isHidden())
        return;
    m_module = module->info.index;
    const auto refused = nmc::whyNot(IntentKind::StopHere, *module);
    look::setPossible(this, refused ? texts::refusal(*refused) : QString(),
                      tr("Holds the motor at its present position (Stop here)."));
}

}  // namespace nmc
