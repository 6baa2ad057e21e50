// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopepresets.h"

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <utility>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

constexpr int kLongestName = 40;

/// In a menu, an & marks a letter.
QString menuText(QString name) {
    return name.replace(u'&', u"&&"_s);
}

}  // namespace

ScopePresets::ScopePresets(std::function<ScopeSetup()> present, QWidget* panel)
    : QObject(panel),
      m_present(std::move(present)),
      m_panel(panel),
      m_menu(new QMenu(tr("Presets"), panel)),
      m_removes(new QMenu(tr("&Remove preset"), panel)) {
    look::name(m_menu, u"scopePresetsMenu"_s, m_menu->title());
    look::name(m_removes, u"scopeRemovePresetMenu"_s, tr("Remove preset"));
    m_menu->setToolTipsVisible(true);
    fillMenu();
}

void ScopePresets::showPresets(const QStringList& presets) {
    m_presets.clear();
    for (qsizetype i = 0; i + 1 < presets.size() && m_presets.size() < kMost; i += 2)
        if (!presets[i].isEmpty())
            m_presets.insert(presets[i], ScopeSetup::fromText(presets[i + 1]));
    fillMenu();
}

void ScopePresets::fillMenu() {
    m_menu->clear();
    for (auto preset = m_presets.cbegin(); preset != m_presets.cend(); ++preset)
        m_menu->addAction(menuText(preset.key()), this,
                          [this, setup = preset.value()] { emit setupChosen(setup); });
    m_menu->addSeparator();
    QAction* saves = m_menu->addAction(tr("&Save as preset…"), this, &ScopePresets::askForName);
    saves->setObjectName(u"scopeSavePresetAction"_s);
    saves->setToolTip(tr("Keeps the present signals, strips, bits and time under a name."));
    m_menu->addMenu(m_removes);
    m_removes->setEnabled(!m_presets.empty());
    m_removes->clear();
    for (const QString& name : m_presets.keys())
        m_removes->addAction(menuText(name), this, [this, name] {
            m_presets.remove(name);
            changed();
        });
}

void ScopePresets::askForName() {
    auto* dialog = new QDialog(m_panel);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Save as preset"));
    look::name(dialog, u"scopePresetDialog"_s, dialog->windowTitle());
    auto* name = form::newText(
        {.name = u"scopePresetName"_s, .accessible = Common::tr("Name"), .maxLength = kLongestName}, dialog);
    QLabel* hint = form::newParagraph(u"scopePresetHint"_s, {}, dialog, 1);
    auto* cancel = form::newPush({u"scopePresetCancelButton"_s, Common::tr("Cancel")}, dialog);
    auto* saves = form::newPush({u"scopePresetSaveButton"_s, tr("Save")}, dialog);
    cancel->setAutoDefault(false);
    saves->setDefault(true);
    const auto refresh = [this, name, hint, saves] {
        const QString typed = name->text().trimmed();
        const bool known = m_presets.contains(typed);
        const bool full = !known && m_presets.size() >= kMost;
        look::setText(hint, known ? tr("Replaces the preset of that name.")
                            : full
                                ? tr("There are %1 presets, which is the most. Remove one first.").arg(kMost)
                                : QString());
        saves->setEnabled(!typed.isEmpty() && !full);
    };
    connect(name, &QLineEdit::textChanged, dialog, refresh);
    connect(cancel, &QPushButton::clicked, dialog, &QDialog::reject);
    connect(saves, &QPushButton::clicked, dialog, &QDialog::accept);
    connect(dialog, &QDialog::accepted, this, [this, name] {
        m_presets.insert(name->text().trimmed(), m_present());
        changed();
    });
    form::fill(
        dialog,
        form::newColumn(dialog, {form::newLine(dialog, {form::newLabel(Common::tr("Name"), name), name}),
                                 hint, form::newLine(dialog, {nullptr, cancel, saves})}),
        1);
    refresh();
    dialog->open();
}

void ScopePresets::changed() {
    fillMenu();
    QStringList presets;
    for (auto preset = m_presets.cbegin(); preset != m_presets.cend(); ++preset)
        presets << preset.key() << preset.value().toText();
    emit presetsChanged(presets);
}

}  // namespace nmc
