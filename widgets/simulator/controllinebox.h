// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QStringList>
#include <QWidget>

class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace nmc {

class GlyphLabel;

/// A control line by keyboard, and the simulator's answer in its own words: the same language as nmcsim's.
class ControlLineBox : public QWidget {
    Q_OBJECT

public:
    explicit ControlLineBox(QWidget* parent = nullptr);

    /// Any line's answer; `json` is not changed but for line breaks between its members.
    void showAnswer(const QString& line, const QByteArray& json);
    void forget();

signals:
    void lineEntered(const QString& line);

private:
    QLineEdit* m_edit;
    GlyphLabel* m_sign;
    QLabel* m_head;
    QPlainTextEdit* m_answer;
};

}  // namespace nmc
