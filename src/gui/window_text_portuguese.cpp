// The Portuguese words of the window.

#include "gui/window_text.h"

namespace raywalk {

std::string_view portuguese(WindowText id) {
  switch (id) {
    case WindowText::menu_walk:
      return "Percurso";
    case WindowText::menu_panels:
      return "Painéis";
    case WindowText::plan:
      return "Planta";
    case WindowText::keys:
      return "Teclas";
    case WindowText::image_settings:
      return "A imagem 3-D";
    case WindowText::settings:
      return "Ajustes";
    case WindowText::settings_hint:
      return "Como a imagem é feita; mapas de calor do que ela custa e do seu ruído";
    case WindowText::integrator:
      return "Integrador";
    case WindowText::accelerator:
      return "Acelerador";
    case WindowText::cost_knobs:
      return "O que tentar";
    case WindowText::cost_reference:
      return "referência";
    case WindowText::cost_split:
      return "Divisão";
    case WindowText::cost_difference:
      return "Diferença";
    case WindowText::cost_rays:
      return "Contra raios";
    case WindowText::cost_tests:
      return "Contra testes";
    case WindowText::cost_seconds:
      return "Contra tempo";
    case WindowText::sampler:
      return "Amostrador";
    case WindowText::light_grid:
      return "Raios por luz: n x n";
    case WindowText::tolerance:
      return "Tolerância";
    case WindowText::samples:
      return "Amostras por pixel";
    case WindowText::precision:
      return "Precisão";
    case WindowText::numerics:
      return "Aritmética";
    case WindowText::epsilon:
      return "Épsilon";
    case WindowText::cost_effects:
      return "Efeitos";
    case WindowText::cost_tries:
      return "Tentativas";
    case WindowText::magnification_hint:
      return "Quão de perto; a roda sobre o desenho faz o mesmo";
    case WindowText::double_:
      return "double";
    case WindowText::single:
      return "float";
    case WindowText::heat:
      return "Mapa de calor";
    case WindowText::walk_samples:
      return "Amostras percorridas";
    case WindowText::heat_none:
      return "nenhum";
    case WindowText::heat_rays:
      return "raios de cada pixel";
    case WindowText::heat_tests:
      return "nós e formas testados";
    case WindowText::heat_time:
      return "tempo";
    case WindowText::heat_noise:
      return "ruído das amostras";
    case WindowText::image_hint:
      return "Arraste para girar, com Shift ou o botão direito para mover, roda para o zoom; clique num pixel para "
             "percorrer os seus raios";
    case WindowText::scrub_hint:
      return "Onde o percurso está; arraste para ir a qualquer lugar";
    case WindowText::speed_hint:
      return "A velocidade de AUTO; pode mudar enquanto ele corre";
    case WindowText::scene_settings:
      return "Cena";
    case WindowText::folder_up:
      return "Acima";
    case WindowText::folder_up_hint:
      return "Ir à pasta que contém esta";
    case WindowText::no_scene_here:
      return "Nenhuma cena (*.toml, *.nff, *.test) nesta pasta";
    case WindowText::folder_unreadable:
      return "Esta pasta não pode ser lida";
    case WindowText::export_slides:
      return "Slides";
    case WindowText::export_slides_hint:
      return "Uma página que percorre os passos, sem rede";
    case WindowText::export_picture:
      return "Imagem";
    case WindowText::export_picture_hint:
      return "A janela como está";
    case WindowText::export_film:
      return "Filme";
    case WindowText::export_film_hint:
      return "A janela passo a passo, até o fim do pixel";
    case WindowText::export_plan:
      return "Planta";
    case WindowText::export_plan_hint:
      return "A planta como desenho de linhas, nítida em qualquer tamanho";
    case WindowText::export_transcript:
      return "Texto";
    case WindowText::export_transcript_hint:
      return "Cada passo como frase, para ler em voz alta";
    case WindowText::export_script:
      return "Roteiro";
    case WindowText::export_script_hint:
      return "A lição para quem apresenta, para imprimir ou ler longe da turma";
    case WindowText::export_steps:
      return "Dados";
    case WindowText::export_steps_hint:
      return "Cada passo com os seus números, para programas";
    case WindowText::swatch_hint:
      return "Escolher a cor";
    case WindowText::breakpoints:
      return "Onde parar";
    case WindowText::breakpoints_hint:
      return "Antes de linhas do código: clique à esquerda de uma linha, ou tecle Ctrl+B. AUTO, Correr e passos "
             "maiores que uma linha param ali.";
    case WindowText::breakpoint_hint:
      return "Parar antes desta linha, ou não mais";
    case WindowText::mark_hint:
      return "Marcar esta linha como a do defeito";
    case WindowText::breakpoints_off:
      return "Este passo da lição ignora todas as paradas.";
    case WindowText::at_depth:
      return "Em DEPTH (0: não)";
    case WindowText::at_pixel:
      return "No pixel (-1: não)";
    case WindowText::at_object:
      return "Ao encontrar";
    case WindowText::at_total:
      return "Reflexão total";
    case WindowText::nowhere:
      return "nada";
    case WindowText::remove_breakpoints:
      return "Remover todas";
    case WindowText::go_to_step:
      return "Ir ao passo";
    case WindowText::status_hint:
      return "Ir a um passo pelo número";
    case WindowText::equation_empty:
      return "Dê um passo: aqui fica o que a linha calcula, com os números do raio.";
    case WindowText::short_image:
      return "3-D";
    case WindowText::short_tree:
      return "Árvore";
    case WindowText::short_microscope:
      return "Micro";
    case WindowText::short_structure:
      return "Caixas";
    case WindowText::corners_hint:
      return "Os vértices se arrastam na planta";
    case WindowText::key_space:
      return "Espaço";
    case WindowText::reading_scene:
      return "Lendo {0} \u2026";
    case WindowText::key_other:
      return "tecla {0}";
    case WindowText::export_as:
      return "Será gravado como {0}";
    case WindowText::film_progress:
      return "Filme: quadro {0} de {1}, Esc termina aqui";
  }
  return {};
}

}  // namespace raywalk
