// The Portuguese texts of the panels.

#include "view/text.h"

namespace raywalk {

std::string_view portuguese(PanelText id) {
  switch (id) {
    case PanelText::depth_badge:
      return "DEPTH {0}";
    case PanelText::rays_badge:
      return "RAIO {0}";
    case PanelText::percent_under:
      return "menos de {0}%";
    case PanelText::stack_main:
      return "MAIN ALGORITHM";
    case PanelText::stack_paths:
      return "PATH TRACING";
    case PanelText::stack_path:
      return "FOLLOW PATH (raio {0})";
    case PanelText::stack_shade:
      return "SHADE (DEPTH {0})";
    case PanelText::stack_returns:
      return "devolve {0}";
    case PanelText::stack_primary_ray:
      return "raio primário do pixel {0}";
    case PanelText::stack_ray_from:
      return "{0} de {1}";
    case PanelText::waits_final:
      return "espera pela cor final";
    case PanelText::waits_refl:
      return "espera por REFLSHADE";
    case PanelText::waits_refr:
      return "espera por REFRSHADE";
    case PanelText::works_on:
      return "em: {0}";
    case PanelText::name_final:
      return "final";
    case PanelText::name_refl:
      return "REFLSHADE";
    case PanelText::name_refr:
      return "REFRSHADE";
    case PanelText::node_future:
      return "{0}: ainda não alcançado";
    case PanelText::node_share:
      return "{0}: no máximo {1} do pixel";
    case PanelText::node_under_way:
      return "ainda não se sabe o que encontra";
    case PanelText::tree_empty:
      return "Aqui vão ficar os raios de um pixel, como árvore. Aperte STEP.";
    case PanelText::stack_empty:
      return "Nada está correndo ainda. Aperte STEP.";
    case PanelText::image_waiting:
      return "Calculando...";
    case PanelText::image_row_marked:
      return "A linha marcada é SCREEN; clique num pixel.";
    case PanelText::image_click:
      return "Clique num pixel para percorrer os seus raios.";
    case PanelText::image_turned:
      return "Girada: O volta à câmera da cena.";
    case PanelText::image_progress:
      return "{0}, faltam {1}";
    case PanelText::too_many_samples:
      return "Só {0} amostras de cada pixel são percorridas: com mais, haveria passos demais.";
    case PanelText::samples_mean:
      return "média de {0} amostras: {1} \u00b1 {2}";
    case PanelText::member_of:
      return "{0} de {1}";
    case PanelText::triangle_of:
      return "triângulo {0} de {1}";
    case PanelText::ghosts_total:
      return "Pontilhado: o que os limites cortaram, até aqui {0} deste pixel";
    case PanelText::ghosts_none:
      return "Nem profundidade nem limiar cortaram nada deste pixel";
    case PanelText::heat_rays:
      return "{0} raios";
    case PanelText::heat_tests:
      return "{0} nós e formas testados";
    case PanelText::heat_time:
      return "{0} µs";
    case PanelText::heat_noise:
      return "desvio padrão {0}";
    case PanelText::short_primary:
      return "primário";
    case PanelText::short_shadow:
      return "sombra";
    case PanelText::short_reflect:
      return "refletido";
    case PanelText::short_refract:
      return "refratado";
    case PanelText::legend_primary:
      return "de EYE através de um pixel de SCREEN";
    case PanelText::legend_shadow:
      return "de uma superfície até uma luz: ela chega?";
    case PanelText::legend_reflect:
      return "espelhado numa superfície";
    case PanelText::legend_refract:
      return "dobrado ao entrar num corpo ou sair dele";
    case PanelText::sign_hit:
      return "encontrou um objeto, que é sombreado";
    case PanelText::sign_missed:
      return "saiu da cena: fundo";
    case PanelText::sign_blocked:
      return "bloqueado: a luz não chega (uma cruz na planta)";
    case PanelText::sign_reached_light:
      return "chegou à luz";
    case PanelText::sign_stub:
      return "não formado (um toco com uma barra na planta)";
    case PanelText::sign_normal:
      return "seta fina num encontro: a normal da superfície";
    case PanelText::to_start:
      return "Ao início";
    case PanelText::to_end:
      return "Ao fim";
    case PanelText::step_bar:
      return "Passo";
    case PanelText::status:
      return "passo {0} de {1} \u00b7 pixel {2} \u00b7 raios {3}";
    case PanelText::status_short:
      return "{0} / {1}";
    case PanelText::status_none:
      return "\u2013";
    case PanelText::first_step_trace:
      return "Aperte STEP para executar a primeira linha, ou AUTO para deixar andar sozinho.";
    case PanelText::first_step_move:
      return "Arraste os objetos, a luz e o olho; depois escolha Traçar.";
    case PanelText::first_step_help:
      return "Escolha Mover para arrumar a cena, ou Traçar para percorrê-la.";
    case PanelText::after_last_step:
      return "Todo pixel de SCREEN tem a sua cor final. CLEAR começa de novo.";
    case PanelText::after_last_step_of_pixel:
      return "Este pixel está pronto: CLEAR o recomeça, S volta a SCREEN.";
    case PanelText::walk_stands_at_end:
      return "O percurso está no fim, mesmo depois de uma mudança; CLEAR o recomeça.";
    case PanelText::walk_stands_at:
      return "O percurso está no passo {0} de {1}.";
    case PanelText::objects_drawn:
      return "{0} de {1} objetos estão desenhados";
    case PanelText::out_of_view:
      return "{0} está fora da vista: Enquadrar (F) mostra a cena inteira.";
    case PanelText::shown_tiny:
      return "A cena aparece muito pequena: Enquadrar (F) a mostra do maior tamanho possível.";
  }
  return {};
}

}  // namespace raywalk
