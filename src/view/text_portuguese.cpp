// The Portuguese texts of things, buttons, menus, questions, properties and notices.

#include "view/text.h"

namespace raywalk {

std::string_view portuguese(TextId id) {
  switch (id) {
    case TextId::solid_sphere:
      return "Esfera sólida";
    case TextId::transparent_sphere:
      return "Esfera transparente";
    case TextId::polygon:
      return "Polígono";
    case TextId::light_source:
      return "Fonte de luz";
    case TextId::short_solid_sphere:
      return "Sólida";
    case TextId::short_transparent_sphere:
      return "Vidro";
    case TextId::short_polygon:
      return "Polígono";
    case TextId::short_light_source:
      return "Luz";
    case TextId::plane:
      return "Chão";
    case TextId::eye:
      return "EYE";
    case TextId::screen:
      return "SCREEN";
    case TextId::untitled:
      return "Sem título";
    case TextId::new_scene_title:
      return "Uma cena nova";
    case TextId::drag_move:
      return "{0}: arraste para mover";
    case TextId::drag_eye:
      return "EYE: arraste para mover o olho e a tela";
    case TextId::drag_view_direction:
      return "Arraste para girar a vista";
    case TextId::drag_screen_height:
      return "Arraste para alongar ou encurtar SCREEN";
    case TextId::drag_screen_distance:
      return "Arraste para aproximar SCREEN de EYE ou afastá-lo";
    case TextId::drag_radius:
      return "{0}: arraste para mudar o raio";
    case TextId::drag_corner:
      return "{0}: arraste para mover este vértice; Delete o remove";
    case TextId::drag_edge:
      return "{0}: arraste para mover; um duplo clique cria um vértice aqui";
    case TextId::drag_rotation:
      return "{0}: arraste para girar";
    case TextId::cell_number:
      return "Pixel {0} de SCREEN";
    case TextId::cell_with_shade:
      return "Pixel {0} de SCREEN: cor final {1}";
    case TextId::ray_from:
      return "{0} de {1}";
    case TextId::ray_of_cell:
      return "{0} do pixel {1}";
    case TextId::ray_of_pixel:
      return "{0} do pixel da imagem";
    case TextId::mode_move:
      return "Mover";
    case TextId::mode_trace:
      return "Traçar";
    case TextId::mode_help:
      return "Ajuda";
    case TextId::tab_image:
      return "Imagem 3-D";
    case TextId::tab_tree:
      return "Árvore";
    case TextId::tab_stack:
      return "Pilha";
    case TextId::tab_legend:
      return "Legenda";
    case TextId::tab_cost:
      return "Custo";
    case TextId::button_step:
      return "STEP";
    case TextId::button_back:
      return "VOLTAR";
    case TextId::button_auto:
      return "AUTO";
    case TextId::button_pause:
      return "PAUSAR";
    case TextId::button_clear:
      return "CLEAR";
    case TextId::button_fit:
      return "Enquadrar";
    case TextId::button_undo:
      return "Desfazer";
    case TextId::button_redo:
      return "Refazer";
    case TextId::button_add:
      return "Adicionar";
    case TextId::button_remove:
      return "Remover";
    case TextId::button_close:
      return "Fechar";
    case TextId::grain:
      return "Um passo é";
    case TextId::grain_line:
      return "uma linha";
    case TextId::grain_ray:
      return "um raio";
    case TextId::grain_pixel:
      return "um pixel";
    case TextId::speed:
      return "Velocidade";
    case TextId::speed_unit:
      return "passos por segundo";
    case TextId::theme:
      return "Tema";
    case TextId::theme_dark:
      return "Escuro";
    case TextId::theme_projector:
      return "Projetor";
    case TextId::ui_scale:
      return "Tamanho";
    case TextId::language:
      return "Idioma";
    case TextId::menu_file:
      return "Arquivo";
    case TextId::menu_edit:
      return "Editar";
    case TextId::menu_view:
      return "Exibir";
    case TextId::menu_new:
      return "Nova";
    case TextId::menu_open:
      return "Abrir...";
    case TextId::menu_recent:
      return "Abrir recente";
    case TextId::menu_save:
      return "Salvar";
    case TextId::menu_save_as:
      return "Salvar como...";
    case TextId::menu_quit:
      return "Sair";
    case TextId::path_label:
      return "Arquivo";
    case TextId::answer_save:
      return "Salvar";
    case TextId::answer_discard:
      return "Não salvar";
    case TextId::answer_recover:
      return "Recuperar";
    case TextId::answer_throw_away:
      return "Jogar fora";
    case TextId::answer_later:
      return "Depois";
    case TextId::answer_overwrite:
      return "Substituir";
    case TextId::answer_cancel:
      return "Cancelar";
    case TextId::ask_unsaved_new:
      return "{0} tem mudanças que não foram salvas. Salvar antes de começar uma cena nova?";
    case TextId::ask_unsaved_open:
      return "{0} tem mudanças que não foram salvas. Salvar antes de abrir {1}?";
    case TextId::ask_unsaved_quit:
      return "{0} tem mudanças que não foram salvas. Salvar antes de sair?";
    case TextId::ask_unsaved_lesson:
      return "A sua própria cena volta agora. Guardar uma cópia da cena da lição, como você a alterou?";
    case TextId::ask_recover:
      return "Raywalk terminou em {1} antes que as mudanças de {0} fossem salvas. Recuperar? \"Depois\" pergunta de "
             "novo na próxima vez.";
    case TextId::ask_recover_other:
      return "Raywalk terminou em {1} antes que as mudanças de {0} fossem salvas. Recuperar no lugar de {2}, que você "
             "abriu agora? \"Depois\" pergunta de novo na próxima vez.";
    case TextId::ask_overwrite:
      return "{0} já existe. Substituir?";
    case TextId::properties:
      return "Propriedades";
    case TextId::nothing_selected:
      return "Clique em algo na planta para ver aqui os seus números.";
    case TextId::name:
      return "Nome";
    case TextId::material:
      return "Material";
    case TextId::ambient:
      return "Ambiente (ka)";
    case TextId::diffuse:
      return "Difusa (kd)";
    case TextId::specular:
      return "Especular (ks)";
    case TextId::shininess:
      return "Polimento (s)";
    case TextId::reflection:
      return "Reflexão (kr)";
    case TextId::transmission:
      return "Transmissão (kt)";
    case TextId::ior:
      return "Índice de refração";
    case TextId::dielectric:
      return "Dielétrico (Fresnel)";
    case TextId::priority:
      return "Prioridade";
    case TextId::filtered_shadow:
      return "Sombra filtrada";
    case TextId::emission:
      return "Emissão";
    case TextId::checker:
      return "Xadrez";
    case TextId::position:
      return "Posição";
    case TextId::direction:
      return "Direção";
    case TextId::centre:
      return "Centro";
    case TextId::radius:
      return "Raio";
    case TextId::height:
      return "Altura em 3-D";
    case TextId::corner:
      return "Vértice {0}";
    case TextId::radii:
      return "Raios";
    case TextId::lowest:
      return "Mais baixo";
    case TextId::highest:
      return "Mais alto";
    case TextId::capped:
      return "Com tampas";
    case TextId::smooth:
      return "Suave";
    case TextId::normal:
      return "Normal";
    case TextId::strength:
      return "Intensidade";
    case TextId::attenuation:
      return "Atenuação (c, l, q)";
    case TextId::view_angle:
      return "Ângulo de visão";
    case TextId::look_at:
      return "Olha para";
    case TextId::screen_distance:
      return "Distância de SCREEN";
    case TextId::screen_width:
      return "Comprimento de SCREEN";
    case TextId::screen_cells:
      return "Pixels de SCREEN";
    case TextId::background:
      return "Fundo";
    case TextId::ambient_light:
      return "Luz ambiente";
    case TextId::depth_limit:
      return "SHADE mais profunda";
    case TextId::threshold:
      return "Parte mínima (limiar)";
    case TextId::saved_as:
      return "Salvo como {0}";
    case TextId::opened:
      return "{0} foi aberto";
    case TextId::recovered:
      return "{0} foi recuperado. Ainda não está salvo.";
    case TextId::refused:
      return "Não foi feito: {0}";
    case TextId::refused_number:
      return "Não foi aceito: espera-se um número de {0} a {1}";
    case TextId::refused_name_empty:
      return "Não foi feito: um nome não pode ficar vazio";
    case TextId::refused_name_taken:
      return "Não foi feito: já há algo chamado {0}";
    case TextId::refused_last_corners:
      return "Não foi feito: um polígono precisa de pelo menos três vértices";
    case TextId::camera_is_the_scenes:
      return "A imagem já é vista pela câmera da cena: gire-a primeiro";
    case TextId::camera_taken:
      return "A câmera da cena está agora onde a imagem era vista";
    case TextId::nothing_to_undo:
      return "Nada a desfazer";
    case TextId::nothing_to_redo:
      return "Nada a refazer";
    case TextId::select_first:
      return "Clique primeiro num objeto ou numa luz";
    case TextId::too_many_steps:
      return "O percurso é longo demais: é mostrado só até DEPTH {0}";
    case TextId::export_endings:
      return "{0}: o final do nome diz o que se grava: .png a janela, .gif um filme dela, .svg a planta, .html slides, "
             ".txt ou .json todos os passos";
    case TextId::too_many_slides:
      return "uma página tem no máximo {0} passos: percorra um pixel, ou vá menos fundo";
    case TextId::save_elsewhere:
      return "Esta cena vem com o Raywalk, e as lições a usam: salve a sua com outro nome ou em outra pasta";
    case TextId::autosave_failed:
      return "O trabalho não pôde ser salvo automaticamente: {0}";
  }
  return {};
}

}  // namespace raywalk
