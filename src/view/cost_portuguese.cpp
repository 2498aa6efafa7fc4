// The Portuguese words of the Cost panel.

#include "view/cost.h"

namespace raywalk {

std::string_view portuguese(CostText id) {
  switch (id) {
    case CostText::empty:
      return "Regule os botões e aperte Tentar: a mesma imagem é traçada assim, o seu custo é contado, e mede-se a "
             "distância até a imagem certa. A escada tenta 1, 4, 16 e 64 amostras.";
    case CostText::under_way:
      return "traçando: {0}";
    case CostText::attempt:
      return "{0}: erro {4}{5}; {1} raios, {2} testes, {3} s";
    case CostText::awaits_reference:
      return "?";
    case CostText::times_floor:
      return " ({0} vezes a referência)";
    case CostText::reference:
      return "referência: {0} amostras por pixel, erro próprio de cerca de {1}";
    case CostText::no_reference:
      return "a referência está a caminho";
    case CostText::samples:
      return "{0} amostras";
    case CostText::sample:
      return "1 amostra";
    case CostText::light_grid:
      return "{0} x {0} por luz";
    case CostText::depth:
      return "profundidade {0}";
    case CostText::threshold:
      return "limiar {0}";
    case CostText::no_threshold:
      return "sem limiar";
    case CostText::single:
      return "float";
    case CostText::double_:
      return "double";
    case CostText::tolerance:
      return "tolerância {0}";
    case CostText::no_tolerance:
      return "não adaptativo";
    case CostText::naive:
      return "ingênua, épsilon {0}";
    case CostText::robust:
      return "robusta";
    case CostText::error_axis:
      return "erro (RMS)";
    case CostText::seconds_axis:
      return "segundos de uma thread";
    case CostText::rays_axis:
      return "raios";
    case CostText::tests_axis:
      return "testes de caixas, células e superfícies";
    case CostText::floor:
      return "o erro da própria referência";
    case CostText::key_rays:
      return "dos raios";
    case CostText::key_time:
      return "do tempo";
    case CostText::difference:
      return "A para {0}, maior diferença {1}";
    case CostText::effects_title:
      return "O que cada efeito acrescenta a esta cena: a imagem com ele, menos a imagem sem ele";
    case CostText::no_effects:
      return "Esta cena não pede nenhum efeito que se possa deixar de fora.";
    case CostText::of_rays:
      return "{0} dos raios";
    case CostText::of_time:
      return "{0} do tempo ({1} a {2})";
    case CostText::all_rays:
      return "raios de sombra";
    case CostText::whole:
      return "Tudo junto: {0} raios em {1} s. Todos os efeitos, pedidos ou não: {2} vezes os raios, {3} vezes o tempo.";
    case CostText::surveying:
      return "medindo: {0}";
  }
  return {};
}

}  // namespace raywalk
