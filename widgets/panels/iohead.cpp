// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/iohead.h"

#include <QLabel>
#include <QVBoxLayout>

#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"
#include "widgets/common/positiontexts.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/boxparts.h"

namespace nmc {

using namespace Qt::StringLiterals;

IoHead::IoHead(ModuleContext& context, QWidget* parent)
    : QFrame(parent),
      m_context(context),
      m_glyph(new GlyphLabel(this)),
      m_module(form::newHeading({}, this)),
      m_type(look::newMutedLabel({}, this, u"ioModuleType"_s)),
      m_state(new QLabel(this)),
      m_meaning(form::newParagraph(u"ioStateMeaning"_s, {}, this)),
      m_name(newNameField(u"ioNameField"_s, tr("Name of this module"), this)) {
    look::name(this, u"ioHead"_s, Common::tr("State of the selected module"));
    m_module->setObjectName(u"ioModuleName"_s);
    m_state->setObjectName(u"ioStateLabel"_s);
    m_state->setFont(look::scaled(font(), 1.5));
    form::setBold(m_state);
    m_glyph->setFont(look::scaled(font(), 1.7));
    const int unit = look::gridUnit(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(unit, unit / 2, unit, unit / 2);
    layout->addLayout(
        new FlowLayout(unit, {m_module, m_type, form::newLabel(Common::tr("Name"), m_name), m_name}));
    layout->addLayout(form::newLine(this, {m_glyph, m_state, {m_meaning, 1}}, 0.5));
    connect(m_name, &QLineEdit::textEdited, this, [this](const QString& text) {
        m_context.edit([text](AxisSettings& axis) { axis.name = text.trimmed().toStdString(); });
    });
    m_context.whenSeen(this, [this] { refresh(); });
}

void IoHead::refresh() {
    const ModuleState& module = m_context.state();
    const Activity activity = module.activity();
    look::setText(m_module, texts::moduleName(module.info.index));
    look::setText(m_type, Common::tr("%1, address %2")
                              .arg(texts::moduleType(module.info.identity))
                              .arg(module.info.address.value()));
    look::setText(m_state, texts::activity(activity));
    // The boxes of this page strike out what was read before; how old it is, is said here once.
    const QString meaning = texts::activityMeaning(activity, module.info.identity.type);
    const auto age = m_context.age();
    look::setText(m_meaning,
                  age ? meaning + u' ' + tr("Last answer: %1.").arg(texts::age(*age, false)) : meaning);
    m_glyph->showActivity(activity);
    showUnlessTyped(m_name, m_context.settings().name);
    setNameLocked(m_name, m_context.whyLocked());
}

}  // namespace nmc
