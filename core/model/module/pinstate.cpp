// SPDX-License-Identifier: MIT
#include "model/module/pinstate.h"

namespace nmc {

void PinState::attached() {
    m_inputs.reset();
    m_told.reset();
    m_pwm.reset();
    m_timer.reset();
    m_stored.reset();
}

struct PinState::Executed {
    PinState& s;

    void operator()(const io::SetDirection& set) const { s.m_inputs = set.inputs; }
    void operator()(const io::SetOutput& set) const { s.m_told = set.outputs; }
    void operator()(const io::SetPwm& set) const { s.m_pwm = {set.pwm1, set.pwm2}; }
    void operator()(const io::SetTimerMode& mode) const { s.m_timer = mode; }
    void operator()(const io::SetSynchOutput& set) const { s.m_stored = set; }
    void operator()(const io::SynchOutput&) const {
        if (!s.m_stored) {  // another host's
            s.m_told.reset();
            s.m_pwm.reset();
            return;
        }
        s.m_told = s.m_stored->outputs;
        s.m_pwm = {s.m_stored->pwm1, s.m_stored->pwm2};
    }
    void operator()(const AnyOf<SetAddress, DefineStatus, ReadStatus, SetBaud, io::SynchInput, Nop,
                                HardReset> auto&) const {}
};

void PinState::apply(const IoCommand& executed) {
    std::visit(Executed{*this}, executed);
}

}  // namespace nmc
