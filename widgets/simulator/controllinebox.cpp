// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/simulator/controllinebox.h"

#include <QFontDatabase>
#include <QHBoxLayout>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QShortcut>

#include "widgets/common/form.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"
#include "widgets/common/texts.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
/// The limit of nmcsim, where an endless line must not fill the memory.
constexpr int kMaxLine = 4'096;
constexpr int kShownLines = 3;
}  // namespace

ControlLineBox::ControlLineBox(QWidget* parent)
    : QWidget(parent),
      m_edit(form::newText(
          {u"simLineEdit"_s, tr("Control line"), kMaxLine,
           tr("Type an nmcsim command, then press Enter: state, set, power-cycle, break, mend, stats, time, fault. Shortcut: Ctrl+L."),
           u"state 1"_s},
          this)),
      m_sign(new GlyphLabel(this)),
      m_head(form::newParagraph(u"simAnswerHead"_s, {}, this)),
      m_answer(new QPlainTextEdit(this)) {
    const QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    m_edit->setFont(fixed);
    look::name(m_answer, u"simAnswer"_s, tr("The simulator's answer"));
    m_answer->setReadOnly(true);
    m_answer->setFont(fixed);
    m_answer->setTabChangesFocus(true);
    m_answer->setWordWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    m_answer->setFixedHeight(m_answer->fontMetrics().lineSpacing() * kShownLines + look::gridUnit(this));
    m_head->setTextInteractionFlags(Qt::TextSelectableByMouse);

    const int unit = look::gridUnit(this);
    auto* entry =
        form::newLine(this, {form::newLabel(tr("Control line"), m_edit), {m_edit, 1}}, form::kUsual);
    auto* head = new QHBoxLayout;
    head->addWidget(m_sign, 0, Qt::AlignTop);
    head->addWidget(m_head, 1);
    setLayout(form::newColumn(this, {entry, head, m_answer}, 1.0 / 3));
    layout()->setContentsMargins(unit, 0, unit, unit / 2);
    forget();

    connect(m_edit, &QLineEdit::returnPressed, this, [this] {
        const QString line = m_edit->text().trimmed();
        m_edit->selectAll();
        if (!line.isEmpty())
            emit lineEntered(line);
    });
    connect(new QShortcut(QKeySequence(Qt::CTRL | Qt::Key_L), this), &QShortcut::activated, m_edit,
            [this] { m_edit->setFocus(Qt::ShortcutFocusReason); });
}

void ControlLineBox::showAnswer(const QString& line, const QByteArray& json) {
    const QJsonObject answer = QJsonDocument::fromJson(json).object();
    const QJsonValue error = answer["error"_L1];
    const bool refused = !error.isUndefined();
    const bool done = answer.size() == 1 && answer["ok"_L1].toBool();
    m_sign->showSeverity(refused ? Severity::Fault : Severity::Normal);
    m_sign->show();
    QFont font = this->font();
    font.setBold(refused);
    m_head->setFont(font);
    look::setText(m_head, refused ? texts::simulatorRefused(line)
                          : done  ? texts::simulatorDid(line)
                                  : texts::simulatorAnswered(line));
    m_answer->setPlainText(error.isString() ? error.toString()
                                            : QString::fromUtf8(json).replace(u",\""_s, u",\n\""_s));
}

void ControlLineBox::forget() {
    m_sign->hide();
    m_head->clear();
    m_answer->clear();
}

}  // namespace nmc
