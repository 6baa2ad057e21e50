// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <functional>

#include "widgets/panels/modulecontext.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;

namespace nmc {

class Command;
class NumberField;

/// One command with everything that its data bytes can express: a check box for each bit, a field for each
/// number, what the chip will do, the bytes, and a button that sends them. What is not offered here, the chip
/// does not have.
class DirectBox : public QGroupBox {
    Q_OBJECT

public:
    struct Spec {
        QString name;   ///< prefix of the object names in it, and its own: "expertLoad"
        QString title;  ///< the command's name in the data sheet
        QString send;   ///< on the button
    };
    DirectBox(ModuleContext& context, const Spec& spec, QWidget* parent);

    QCheckBox* addFlag(const QString& name, const QString& text);
    QComboBox* addChoice(const QString& name, const QString& label, const QStringList& choices);
    /// A value that is sent if its box is checked, or always if it has no box.
    struct Value {
        QCheckBox* loaded = nullptr;
        NumberField* field = nullptr;

        [[nodiscard]] bool sent() const;
        /// The number in the field; 0 if there is none.
        [[nodiscard]] double value() const;
    };
    Value addValue(const QString& name, const QString& text, double min, double max, bool optional);

    /// `command` returns the command as it is set here, `meaning` what the chip does with it. Both are called
    /// whenever something changes.
    void setCommand(std::function<ModuleCommand()> command,
                    std::function<QString(const ModuleCommand&)> meaning);

private:
    [[nodiscard]] QString named(const QString& name) const;
    void addRow(QWidget* left, QWidget* right);
    [[nodiscard]] QString problem() const;
    void refresh();

    ModuleContext& m_context;
    QString m_name;
    QGridLayout* m_grid;
    QLabel* m_meaning;
    QLabel* m_bytes;
    Command* m_send;
    std::vector<Value> m_values;
    std::function<ModuleCommand()> m_command;
    std::function<QString(const ModuleCommand&)> m_tell;
};

}  // namespace nmc
