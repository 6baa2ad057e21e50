// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/amplifierbox.h"

#include <QCheckBox>
#include <QLabel>

#include "widgets/common/askdialog.h"
#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
using servo::LimitStop;

/// The fields of the form that the command sends.
enum Setting : std::size_t { Limits, ThreePhase, Antiphase, StepAndDirection, FastPath };

QString onOrOff(bool on) {
    return on ? Common::tr("on") : Common::tr("off");
}
}  // namespace

AmplifierBox::AmplifierBox(ModuleContext& context, QWidget* parent)
    : StagedForm(context,
                 {.what = u"Amplifier"_s,
                  .undo = tr("Undo the last edit of the amplifier settings"),
                  .redo = tr("Redo the edit of the amplifier settings"),
                  .revert = tr("Revert the amplifier settings to those last sent"),
                  .sentOnes = tr("Restores the amplifier settings last sent. Sends nothing."),
                  .none = tr("Clears the fields: no amplifier settings have been sent yet. Sends nothing.")},
                 parent),
      m_limits(form::newChoice(
          {.name = u"limitProtectionBox"_s,
           .accessible = tr("Limit inputs"),
           .options = {{tr("do nothing"), static_cast<int>(LimitStop::None)},
                       {tr("stop abruptly"), static_cast<int>(LimitStop::Abruptly)},
                       {tr("switch the motor off"), static_cast<int>(LimitStop::MotorOff)}},
           .meaning = tr(
               "What the module does by itself when limit 1 closes while it counts up, or limit 2 while it "
               "counts down. It stays armed.")},
          this)),
      m_apply(new Command({.name = u"applyAmplifierButton"_s,
                           .icon = u"send"_s,
                           .text = tr("Apply…"),
                           .accessible = tr("Apply the amplifier settings")},
                          this, [this] { apply(); })),
      m_state(form::newParagraph(u"amplifierState"_s, tr("Amplifier settings of the module"), this)),
      m_multiplier(form::newNumber({.name = u"stepMultiplierField"_s,
                                    .accessible = tr("Step multiplier"),
                                    .min = 1,
                                    .max = 255,
                                    .digits = 4,
                                    .meaning = tr("Counts that one step pulse moves the motor.")},
                                   this)),
      m_setMultiplier(new Command({.name = u"setMultiplierButton"_s,
                                   .icon = u"send"_s,
                                   .text = tr("Set"),
                                   .accessible = tr("Set the step multiplier")},
                                  this, [this] { setMultiplier(); })),
      m_savesAddress(newBox(u"saveAddressBox"_s, tr("Keep its address and group"),
                            tr("It comes back at this address after a power cycle, without a search."))),
      m_savesAmplifier(newBox(u"saveAmplifierBox"_s, tr("Amplifier on at power-up"),
                              tr("AMP_EN goes high by itself after each power-up."))),
      m_savesServo(newBox(
          u"saveServoBox"_s, tr("Servo on at power-up"),
          tr("The servo switches on by itself after each power-up, with the saved gains, even with no panel connected."))),
      m_save(new Command({.name = u"saveConfigurationButton"_s,
                          .icon = u"download"_s,
                          .text = tr("Save in module…"),
                          .accessible = tr("Save in module: configuration for power-up")},
                         this, [this] { save(); })),
      m_erase(new Command({.name = u"eraseConfigurationButton"_s,
                           .icon = u"eraser"_s,
                           .text = tr("Erase saved…"),
                           .accessible = tr("Erase saved configuration of the module")},
                          this, [this] { erase(); })) {
    look::name(this, u"amplifierPage"_s, Common::tr("Amplifier"));
    auto* grid = new FormGrid(this, 4, {.ends = 1, .across = 1, .down = 0.5});
    buildDrive(*grid);
    grid->addGap(1);
    buildSaved(*grid);
    grid->end();
    grid->setColumnStretch(2, 1);
    grid->setColumnStretch(3, 0);
    begin(*m_apply);
}

QCheckBox* AmplifierBox::newBox(const QString& objectName, const QString& text, const QString& meaning) {
    auto* box = form::newCheck({.name = objectName, .text = text, .meaning = meaning}, this);
    connect(box, &QCheckBox::clicked, this, [this] { refresh(); });
    return box;
}

void AmplifierBox::addSetting(FormGrid& grid, const form::Check& check) {
    addField(&grid, {.object = check.name.chopped(3), .label = {}, .meaning = check.meaning},
             form::newCheck(check, this));
}

/// The settings, in the order of Setting.
void AmplifierBox::buildDrive(FormGrid& grid) {
    addField(&grid,
             {.object = u"limitProtection"_s, .label = tr("Limit inputs"), .meaning = m_limits->toolTip()},
             m_limits);
    addSetting(grid,
               {.name = u"threePhaseBox"_s,
                .text = tr("3-phase commutation"),
                .meaning = tr(
                    "For a brushless motor with Hall sensors and a 3-phase amplifier. Off: a brush motor.")});
    addSetting(
        grid, {.name = u"antiphaseBox"_s,
               .text = tr("Antiphase PWM"),
               .meaning =
                   tr("For a locked-antiphase amplifier: 50 % PWM is zero output. Off: PWM and direction.")});
    addSetting(
        grid,
        {.name = u"stepperInputBox"_s,
         .text = tr("Step and direction input"),
         .meaning = tr(
             "The motor follows step pulses at the limit pins instead of commands. The limit inputs then give no protection.")});
    addSetting(grid, {.name = u"fastPathBox"_s,
                      .text = Common::tr("Fast path"),
                      .meaning = tr("Path points at 60 and 120 Hz instead of 30 and 60 Hz.")});
    buildCommands();
    grid.addWide(m_state);
    grid.addWide(new FlowLayout(look::gridUnit(this), {undoCommand()->button(), redoCommand()->button(),
                                                       revertCommand()->button(), m_apply->button()}));
    grid.addWide(hint());
    m_multiplier->showValue(1);
    connect(m_multiplier, &NumberField::edited, this, [this] { refresh(); });
    grid.addRow(tr("Step multiplier"), m_multiplier, {nullptr, m_setMultiplier->button()});
}

void AmplifierBox::buildSaved(FormGrid& grid) {
    QLabel* heading = form::newHeading(tr("Saved in the module, for power-up"), this);
    heading->setWordWrap(true);
    grid.addWide(heading);
    grid.addWide(form::newRemark(
        tr("Saves these choices, the settings above, the gains, the velocity and the acceleration as the module has them now. They come back at each power-up. 3-phase and antiphase come back after a reset, too. Both buttons restart the module: its motor switches off, and it needs its gains again."),
        this));
    for (QCheckBox* box : {m_savesAddress, m_savesAmplifier, m_savesServo})
        grid.addWide(box);
    grid.addWide(new FlowLayout(look::gridUnit(this), {m_erase->button(), m_save->button()}));
}

std::optional<StagedForm::Values> AmplifierBox::kept() const {
    if (const auto& fastPath = context().settings().fastPath; !m_edited && !sent() && fastPath)
        return Values{std::nullopt, std::nullopt, std::nullopt, std::nullopt, *fastPath ? 1 : 0};
    return m_edited;
}

std::optional<StagedForm::Values> AmplifierBox::sent() const {
    const auto& io = context().state().scIo;
    if (!io)
        return std::nullopt;
    return Values{static_cast<int>(io->limitStop), io->threePhase, io->antiphase, io->stepAndDirection,
                  io->fastPath};
}

void AmplifierBox::keep() {
    m_edited = entered();
}

std::optional<servo::ScIoControl> AmplifierBox::wanted() const {
    if (!complete())
        return std::nullopt;
    const auto on = [this](Setting setting) { return field(setting).value() == 1; };
    return servo::ScIoControl{.limitStop = form::chosen<LimitStop>(m_limits),
                              .threePhase = on(ThreePhase),
                              .antiphase = on(Antiphase),
                              .fastPath = on(FastPath),
                              .stepAndDirection = on(StepAndDirection)};
}

/// Takes the settings that the module has, not those in the fields.
servo::HardReset AmplifierBox::wantedSaved() const {
    const servo::ScIoControl now = context().state().scIo.value_or(servo::ScIoControl{});
    return {.save = true,
            .restoreAddresses = m_savesAddress->isChecked(),
            .amplifierOn = m_savesAmplifier->isChecked(),
            .servoOn = m_savesServo->isChecked(),
            .stepAndDirection = now.stepAndDirection,
            .limitProtection = now.limitStop != LimitStop::None,
            .threePhase = now.threePhase,
            .antiphase = now.antiphase};
}

QString AmplifierBox::stateText() const {
    const auto& now = context().state().scIo;
    if (!now)
        return tr(
            "? Unknown: nothing has been applied in this connection, and the settings cannot be read back. The module may have saved settings.");
    return tr("✓ Applied: 3-phase %1, antiphase %2, step and direction %3, limits %4.")
        .arg(onOrOff(now->threePhase), onOrOff(now->antiphase), onOrOff(now->stepAndDirection),
             m_limits->itemText(m_limits->findData(static_cast<int>(now->limitStop))));
}

void AmplifierBox::refreshRest() {
    look::setText(m_state, stateText());
    const QString now = context().reasonNow(IntentKind::ControlSc);
    const auto wanted = this->wanted();
    QString reason = now;
    if (reason.isEmpty() && !wanted)
        reason = tr("Choose what the limit inputs do.");
    if (reason.isEmpty() && wanted->stepAndDirection && wanted->limitStop != LimitStop::None)
        reason = tr("Step and direction uses the limit pins: set the limit inputs to do nothing.");
    if (reason.isEmpty() && context().state().scIo == wanted)
        reason = tr("The module already has these settings.");
    m_apply->setPossible(reason, tr("Takes AMP_EN low and sends these settings."));
    const auto& gains = context().state().gains;
    QString multiplier = context().reasonNow(IntentKind::ApplyGains);
    if (multiplier.isEmpty())
        multiplier = gains ? m_multiplier->problemText() : texts::refusal(Refusal::GainsUnknown);
    if (multiplier.isEmpty() && context().runningProcedure())  // the gains may be those of a trial
        multiplier = tr("A task is running on this module: wait for its end, or cancel it.");
    m_setMultiplier->setPossible(multiplier, tr("Sends the module's present gains with this multiplier."));
    QString save = now;
    if (save.isEmpty() && !context().state().scIo)
        save = tr("Apply the amplifier settings first: the module's present settings are unknown.");
    m_save->setPossible(save, tr("Saves the module's present settings and restarts it."));
    m_erase->setPossible(now, tr("Erases the module's saved configuration and restarts it."));
    AskDialog::reviewAll(*window());
}

void AmplifierBox::question(const QString& name, const QString& title, const Command& of,
                            const std::function<QString()>& text, const QString& verb,
                            const std::function<Intent()>& intent) {
    // While another module's page is shown, this one is in no window, and does not follow its module.
    const auto shown = [this, &of, text] {
        return window()->isVisible() && of.isEnabled() ? text() : QString();
    };
    AskDialog::ask({.name = name,
                    .title = title,
                    .text = shown,
                    .stay = Common::tr("Cancel"),
                    .stayName = name + u"Cancel"_s},
                   {{verb, name + u"Go"_s, [this, intent] { context().ask(intent()); }}}, this);
}

void AmplifierBox::apply() {
    const auto text = [this] {
        return tr("Apply these settings to %1? If 3-phase, antiphase or step and direction do not match the amplifier and its wiring, the amplifier can be destroyed, or the motor can run away once it is enabled.")
            .arg(texts::moduleName(context().state().info.index));
    };
    question(u"applyAmplifierQuestion"_s, tr("Apply amplifier settings"), *m_apply, text,
             tr("Apply settings"), [this] { return intent::ControlSc{*wanted()}; });
}

void AmplifierBox::save() {
    const auto text = [this] {
        const servo::HardReset saved = wantedSaved();
        QString words =
            tr("Save the configuration of %1? It takes effect at each power-up, whatever is connected then. The module restarts now: its motor switches off, and it needs its gains again.")
                .arg(texts::moduleName(context().state().info.index));
        if (saved.amplifierOn || saved.servoOn)
            words += u' ' + tr("Its motor will be driven right after power-up, without a command.");
        return words;
    };
    question(u"saveConfigurationQuestion"_s, tr("Save in module"), *m_save, text, tr("Save and restart"),
             [this] { return intent::SaveConfiguration{wantedSaved()}; });
}

void AmplifierBox::erase() {
    const auto text = [this] {
        return tr("Erase the saved configuration of %1? From the next power-up it starts with its default settings. It restarts now: its motor switches off, and it needs its gains again.")
            .arg(texts::moduleName(context().state().info.index));
    };
    question(u"eraseConfigurationQuestion"_s, tr("Erase saved configuration"), *m_erase, text,
             tr("Erase and restart"), [] { return intent::SaveConfiguration{servo::HardReset{}}; });
}

void AmplifierBox::setMultiplier() {
    auto gains = context().state().gains;
    const auto value = m_multiplier->value();
    if (!gains || !value)
        return;
    gains->sm = static_cast<std::uint8_t>(*value);
    if (!gains->db)
        gains->db = std::uint8_t{0};
    context().ask(intent::ApplyGains{*gains});
}

}  // namespace nmc
