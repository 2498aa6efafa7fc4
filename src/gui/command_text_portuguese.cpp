// What the commands are called in Portuguese, and what they do.

#include "gui/command_text.h"
#include "view/text.h"

namespace raywalk {

CommandText portuguese(Command command) {
  switch (command) {
    case Command::new_scene:
      return {portuguese(TextId::menu_new), "começar uma cena nova"};
    case Command::open:
      return {portuguese(TextId::menu_open), "abrir um arquivo de cena"};
    case Command::save:
      return {portuguese(TextId::menu_save), "gravar a cena no seu arquivo"};
    case Command::save_as:
      return {portuguese(TextId::menu_save_as), "gravar a cena em outro arquivo"};
    case Command::quit:
      return {portuguese(TextId::menu_quit), "fechar a janela"};
    case Command::undo:
      return {portuguese(TextId::button_undo), "desfazer a última mudança"};
    case Command::redo:
      return {portuguese(TextId::button_redo), "fazer de novo a mudança desfeita"};
    case Command::remove:
      return {portuguese(TextId::button_remove), "remover o que está selecionado"};
    case Command::deselect:
      return {portuguese(TextId::button_close), "não selecionar nada; de volta ao código"};
    case Command::select_next:
      return {"Selecionar próximo", "selecionar a próxima coisa"};
    case Command::select_previous:
      return {"Selecionar anterior", "selecionar a coisa anterior"};
    case Command::edit_properties:
      return {portuguese(TextId::properties), "digitar os números do que está selecionado; Tab vai de um ao próximo"};
    case Command::add_solid_sphere:
      return {portuguese(TextId::solid_sphere), "adicionar uma esfera sólida"};
    case Command::add_transparent_sphere:
      return {portuguese(TextId::transparent_sphere), "adicionar uma esfera transparente"};
    case Command::add_polygon:
      return {portuguese(TextId::polygon), "adicionar um polígono"};
    case Command::add_light:
      return {portuguese(TextId::light_source), "adicionar uma fonte de luz"};
    case Command::mode_move:
      return {portuguese(TextId::mode_move), "arrumar a cena: arrastar, adicionar, mudar"};
    case Command::mode_trace:
      return {portuguese(TextId::mode_trace), "percorrer os raios pela cena"};
    case Command::mode_help:
      return {portuguese(TextId::mode_help), "ler o que tudo é e faz"};
    case Command::step:
      return {portuguese(TextId::button_step),
              "um passo adiante: uma linha, um raio ou um pixel, como se escolhe ao lado da velocidade"};
    case Command::step_back:
      return {portuguese(TextId::button_back), "dar um passo atrás"};
    case Command::step_ray:
      return {"Próximo raio", "ir até onde o próximo raio se forma"};
    case Command::step_ray_back:
      return {"Raio anterior", "voltar até onde o raio anterior se formou"};
    case Command::step_pixel:
      return {"Próximo pixel", "ir até o pixel ter a sua cor final"};
    case Command::step_pixel_back:
      return {"Pixel anterior", "voltar até onde o pixel anterior teve a sua cor final"};
    case Command::step_over:
      return {"Passar por cima", "avançar uma linha, e por toda a SHADE que ela chama"};
    case Command::step_back_over:
      return {"Voltar por cima", "voltar uma linha; do fim de uma SHADE até antes da sua chamada"};
    case Command::step_out:
      return {"Sair da SHADE", "ir até a SHADE em curso devolver o seu valor"};
    case Command::step_back_out:
      return {"Voltar à chamada", "voltar até antes da chamada da SHADE em curso"};
    case Command::run_on:
      return {"Correr", "ir até a próxima parada, ou até o fim"};
    case Command::run_back:
      return {"Correr de volta", "voltar até a parada anterior, ou até o início"};
    case Command::break_here:
      return {"Parada aqui", "fazer o percurso parar antes da próxima linha; outra vez: não mais"};
    case Command::breakpoints:
      return {"Paradas, ir a um passo\u2026", "onde o percurso para, e um passo aonde ir"};
    case Command::play:
      return {portuguese(TextId::button_auto), "andar sozinho; outra vez: pausar. Menos e mais mudam a velocidade"};
    case Command::clear:
      return {portuguese(TextId::button_clear), "apagar todos os raios e começar de novo"};
    case Command::first:
      return {"Ao início", "ir até antes do primeiro passo"};
    case Command::last:
      return {"Ao fim", "ir até depois do último passo"};
    case Command::slower:
      return {"Mais lento", "dividir por dois a velocidade de AUTO"};
    case Command::faster:
      return {"Mais rápido", "dobrar a velocidade de AUTO"};
    case Command::grain_line:
      return {portuguese(TextId::grain_line), "um passo é uma linha do código"};
    case Command::grain_ray:
      return {portuguese(TextId::grain_ray), "um passo vai até o próximo raio"};
    case Command::grain_pixel:
      return {portuguese(TextId::grain_pixel), "um passo vai até o próximo pixel"};
    case Command::tab_image:
      return {portuguese(TextId::tab_image), "a imagem que EYE vê"};
    case Command::tab_tree:
      return {portuguese(TextId::tab_tree), "que raio levou a qual, neste pixel"};
    case Command::tab_stack:
      return {portuguese(TextId::tab_stack), "as chamadas que esperam umas pelas outras"};
    case Command::tab_legend:
      return {portuguese(TextId::tab_legend), "o que as linhas e os sinais significam"};
    case Command::tab_cost:
      return {portuguese(TextId::tab_cost), "ajustes comparados entre si"};
    case Command::tab_equation:
      return {"Equação", "o que a linha calculou, com os números deste raio"};
    case Command::zoom_in:
      return {"Aproximar", "mostrar menos da planta, maior"};
    case Command::zoom_out:
      return {"Afastar", "mostrar mais da planta, menor"};
    case Command::fit:
      return {portuguese(TextId::button_fit), "mostrar a cena inteira"};
    case Command::lines:
      return {"Linhas no espaço", "mostrar a cena como linhas no espaço, ou a planta de novo"};
    case Command::ghosts:
      return {"O que foi cortado", "raios que a profundidade e o limiar proibiram"};
    case Command::tweens:
      return {"Raios em movimento", "deixar cada raio crescer ao ser formado, ou mostrá-lo de uma vez"};
    case Command::predict:
      return {"Prever", "antes de cada raio, uma seta para onde vai ou um clique no que encontra"};
    case Command::save_predictions:
      return {"Salvar previsões...", "anotar todos os palpites desta sessão e o erro de cada um"};
    case Command::export_walk:
      return {"Exportar...", "gravar o percurso como imagem, filme, slides ou transcrição"};
    case Command::walk_strip:
      return {"Voltar a SCREEN", "percorrer de novo os pixels de SCREEN, em vez de um da imagem"};
    case Command::reset_view:
      return {"Vista original", "olhar de onde se olhava no início"};
    case Command::use_camera:
      return {"Usar como câmera da cena", "pôr EYE onde a imagem é vista agora"};
    case Command::image_settings:
      return {"Ajustes", "como a imagem é feita, e mapas de calor do que ela custa"};
    case Command::heat:
      return {"Mapa de calor", "mostrar o que cada pixel custa: raios, testes, tempo; depois a imagem de novo"};
    case Command::cost_knobs:
      return {"Botões", "com que se faz a próxima tentativa"};
    case Command::cost_try:
      return {"Tentar", "traçar assim, contar o custo, medir o erro"};
    case Command::cost_ladder:
      return {"Escada", "tentar 1, 4, 16 e 64 amostras"};
    case Command::cost_forget:
      return {"Esquecer", "esquecer tudo o que foi tentado"};
    case Command::cost_next:
      return {"Próxima como A", "mostrar a próxima tentativa como A"};
    case Command::cost_against:
      return {"Próxima como B", "comparar com a próxima tentativa"};
    case Command::cost_kind:
      return {"Divisão", "duas imagens, ou a sua diferença"};
    case Command::cost_axis:
      return {"Raios", "erro contra raios, testes ou tempo"};
    case Command::cost_split_left:
      return {"Divisão à esquerda", "movê-la para a esquerda"};
    case Command::cost_split_right:
      return {"Divisão à direita", "movê-la para a direita"};
    case Command::cost_page:
      return {"Efeitos", "o que cada efeito acrescenta, ou de novo as tentativas"};
    case Command::tab_microscope:
      return {"Microscópio", "um encontro até os últimos dígitos: o que a aritmética ingênua faz dele"};
    case Command::magnify:
      return {"Ampliar", "olhar o encontro mais de perto"};
    case Command::diminish:
      return {"Ampliar menos", "ver mais em volta do encontro"};
    case Command::to_numbers:
      return {"Até os floats", "tão perto quanto os números estão"};
    case Command::to_scene:
      return {"Até a cena", "sem ampliação"};
    case Command::numerics_robust:
      return {"Robusta", "a cena é traçada com limites de erro e aritmética exata"};
    case Command::numerics_naive:
      return {"Ingênua", "a cena é traçada como nos livros, com raios que deixam as superfícies por um épsilon"};
    case Command::precision_double:
      return {"Double", "percurso e imagem em números de 53 bits"};
    case Command::precision_float:
      return {"Float", "percurso e imagem em números de 24 bits"};
    case Command::tab_structure:
      return {"Estrutura", "a busca deste raio caixa por caixa, e o que BVH, grade e árvores poupam"};
    case Command::structure_next:
      return {"Próxima caixa", "um passo adiante na busca ou na construção"};
    case Command::structure_back:
      return {"Caixa anterior", "um passo atrás na busca ou na construção"};
    case Command::structure_last:
      return {"Última caixa", "ao fim da busca ou da construção"};
    case Command::structure_first:
      return {"Primeira caixa", "ao início da busca ou da construção"};
    case Command::structure_kind:
      return {"Próxima estrutura", "buscar no próximo tipo de estrutura"};
    case Command::structure_page:
      return {"Busca ou construção", "como a estrutura foi construída, ou a busca de novo"};
    case Command::turn_left:
      return {"Girar à esquerda", "girar a imagem ou as linhas para a esquerda"};
    case Command::turn_right:
      return {"Girar à direita", "girar a imagem ou as linhas para a direita"};
    case Command::turn_up:
      return {"Girar para cima", "girar a imagem ou as linhas para cima"};
    case Command::turn_down:
      return {"Girar para baixo", "girar a imagem ou as linhas para baixo"};
    case Command::shift_left:
      return {"Mover à esquerda", "mover a imagem ou as linhas para a esquerda"};
    case Command::shift_right:
      return {"Mover à direita", "mover a imagem ou as linhas para a direita"};
    case Command::shift_up:
      return {"Mover para cima", "mover a imagem ou as linhas para cima"};
    case Command::shift_down:
      return {"Mover para baixo", "mover a imagem ou as linhas para baixo"};
    case Command::approach:
      return {"Mais perto", "chegar mais perto"};
    case Command::recede:
      return {"Mais longe", "ir mais longe"};
    case Command::theme:
      return {portuguese(TextId::theme), "escuro, ou claro e grande para um projetor"};
    case Command::language:
      return {portuguese(TextId::language), "falar a próxima língua: English, Portugu\u00eas"};
    case Command::scale_up:
      return {"Maior", "aumentar letras e botões"};
    case Command::scale_down:
      return {"Menor", "diminuir letras e botões"};
    case Command::scale_reset:
      return {"Tamanho usual", "letras e botões como no início"};
    case Command::exchange:
      return {"Trocar planta e painel", "fazer a planta e este painel trocarem de lugar"};
    case Command::full_screen:
      return {"Tela cheia", "ocupar a tela toda, ou não mais"};
    case Command::lessons:
      return {"Lições", "aprender passo a passo: prever, depois ver"};
    case Command::bugs:
      return {"Ache o defeito", "um traçador está quebrado: achar a linha com defeito"};
    case Command::bug_surprise:
      return {"Surpreenda-me", "caçar um defeito que ainda não foi achado"};
    case Command::bug_mark:
      return {"Marcar esta linha", "marcar a linha recém-executada; outra vez: é ela?"};
    case Command::bug_cure:
      return {"Ver a cura", "desistir: que linha era, o que estava errado, e a cura"};
    case Command::bug_mend:
      return {"Consertar o defeito", "traçar sem o defeito achado, ou de novo com ele"};
    case Command::menu:
      return {"Menus", "abrir o primeiro menu, depois o próximo; setas e Enter escolhem"};
  }
  return {};
}

}  // namespace raywalk
