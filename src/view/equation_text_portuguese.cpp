// The Portuguese words of the live equation.

#include "view/equation_text.h"

namespace raywalk {

std::string_view portuguese(EquationText id) {
  switch (id) {
    case EquationText::pixel:
      return "pixel";
    case EquationText::of:
      return "de";
    case EquationText::unit_direction:
      return "D tem comprimento 1; por isso t é a distância a partir de EYE";
    case EquationText::stands_at:
      return "está em";
    case EquationText::as_far_from_normal:
      return "tão longe da normal quanto chegou:";
    case EquationText::sine:
      return "sen";
    case EquationText::slower_beyond:
      return "mais lento adiante: aproxima-se da normal";
    case EquationText::faster_beyond:
      return "mais rápido adiante: afasta-se da normal";
    case EquationText::as_fast_beyond:
      return "igualmente rápido adiante: em linha reta";
    case EquationText::fresnel:
      return "Fresnel: a parte que se reflete aqui";
    case EquationText::depth_allowed:
      return "DEPTH + 1 ≤ limite?";
    case EquationText::share_allowed:
      return "parte do pixel ≥ limiar?";
    case EquationText::no_ray:
      return "nenhum raio se forma";
    case EquationText::light_behind:
      return "a luz está atrás da superfície";
    case EquationText::spot_elsewhere:
      return "o foco não ilumina para este lado";
    case EquationText::nothing_between:
      return "nenhuma superfície entre o ponto e a luz";
    case EquationText::nothing_ahead:
      return "nenhuma superfície tem t acima de 0";
    case EquationText::blocked_before:
      return "antes da luz: bloqueado";
    case EquationText::nearer_root:
      return "t₀: a mais próxima, e à frente";
    case EquationText::other_root_behind:
      return "t₁: a outra fica para trás";
    case EquationText::other_root_is_start:
      return "t₁: na outra o raio começou";
    case EquationText::yes:
      return "sim";
    case EquationText::no:
      return "não";
    case EquationText::above_zero:
      return "acima de 0: sim";
    case EquationText::zero:
      return "0: não";
    case EquationText::no_such_angle:
      return "esse ângulo não existe: reflexão interna total";
    case EquationText::background:
      return "fundo";
    case EquationText::ambient:
      return "ambiente";
    case EquationText::emission:
      return "emissão";
    case EquationText::diffuse:
      return "difusa";
    case EquationText::highlight:
      return "brilho";
    case EquationText::passed:
      return "tudo isso vezes o que o caminho deixa passar:";
    case EquationText::direction:
      return "direção";
    case EquationText::light:
      return "luz";
    case EquationText::weight:
      return "peso";
    case EquationText::share:
      return "parte";
    case EquationText::share_left:
      return "parte que resta";
    case EquationText::absorbed:
      return "absorvido: nada";
    case EquationText::survival:
      return "continua com probabilidade";
  }
  return {};
}

}  // namespace raywalk
