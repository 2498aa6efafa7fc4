// The Portuguese words of the Microscope.

#include "view/microscope.h"

namespace raywalk {

std::string_view portuguese(ScopeText id) {
  switch (id) {
    case ScopeText::empty:
      return "Ande até um encontro, com STEP ou um clique numa célula: aqui ele é visto até o último dígito dos seus "
             "números.";
    case ScopeText::title:
      return "{0} encontra {1}";
    case ScopeText::robust:
      return "robusta";
    case ScopeText::naive:
      return "ingênua";
    case ScopeText::naive_start:
      return "a ingênua parte daqui";
    case ScopeText::error_box:
      return "caixa de erro";
    case ScopeText::crossing:
      return "cruzamento verdadeiro";
    case ScopeText::row_hit:
      return "encontra";
    case ScopeText::row_t:
      return "t";
    case ScopeText::row_t_error:
      return "erro de t";
    case ScopeText::row_point:
      return "ponto";
    case ScopeText::row_start:
      return "partida";
    case ScopeText::nothing:
      return "nada";
    case ScopeText::none:
      return "\u2013";
    case ScopeText::ulp:
      return "{0} ulp";
    case ScopeText::outside:
      return "{0} ulp fora";
    case ScopeText::inside:
      return "{0} ulp dentro";
    case ScopeText::on_surface:
      return "na superfície";
    case ScopeText::at_point:
      return "do ponto";
    case ScopeText::leaves:
      return "sai";
    case ScopeText::hits_own:
      return "encontra a si";
    case ScopeText::goes_astray:
      return "se desvia";
    case ScopeText::some_hit_own:
      return "{0} de {1} encontram a si";
    case ScopeText::some_astray:
      return "{0} de {1} se desviam";
    case ScopeText::off_sight:
      return "{0}: a {1} ulp";
    case ScopeText::one_cell:
      return "1 célula = 1 ulp = {0}";
    case ScopeText::two_cells:
      return "1 ulp = {1} em {0}, {3} em {2}";
    case ScopeText::bar:
      return "{0} = {1} ulp";
    case ScopeText::says_missed:
      return "A aritmética ingênua não vê esta superfície. O raio a encontra de verdade.";
    case ScopeText::says_invented:
      return "A aritmética ingênua acha um encontro aqui. Na verdade o raio não encontra nada.";
    case ScopeText::says_acne:
      return "Ingênua: o {1} parte {0} e encontra a própria superfície que deixa. Disso vêm manchinhas, a acne.";
    case ScopeText::says_wrong_side:
      return "Ingênua: os raios partem {0}, do lado errado da superfície.";
    case ScopeText::says_astray:
      return "Ingênua: os raios partem {0}, e um encontra outra coisa que a que está lá de verdade.";
    case ScopeText::says_apart:
      return "Os dois pontos distam {0} ulp. Os raios da ingênua partem {1}, os da robusta, do seu ponto.";
    case ScopeText::says_alike:
      return "As duas acham o mesmo encontro. Os raios da ingênua partem {0}: aqui isso não faz mal. Os da robusta não "
             "precisam dessa distância.";
    case ScopeText::says_alike_at_surface:
      return "As duas acham o mesmo encontro, e nenhum raio erra aqui.";
  }
  return {};
}

}  // namespace raywalk
