// The list of keys in Portuguese.

#include "gui/key_text.h"

namespace raywalk {

std::string_view portuguese(KeyText id) {
  switch (id) {
    case KeyText::steps:
      return "um passo adiante \u00b7 atrás";
    case KeyText::rays:
      return "ao próximo raio \u00b7 ao raio anterior";
    case KeyText::pixels:
      return "ao fim do pixel \u00b7 do pixel anterior";
    case KeyText::over:
      return "por cima da SHADE que uma linha chama \u00b7 de volta por cima";
    case KeyText::out:
      return "para fora da SHADE em curso \u00b7 de volta até antes da chamada";
    case KeyText::run:
      return "até a próxima parada \u00b7 de volta à anterior";
    case KeyText::breaks:
      return "uma parada antes da próxima linha \u00b7 todas as paradas, e ir a um passo";
    case KeyText::ends:
      return "ao início \u00b7 ao fim";
    case KeyText::auto_clear:
      return "AUTO, e pausa \u00b7 CLEAR";
    case KeyText::speed:
      return "AUTO mais lento \u00b7 mais rápido";
    case KeyText::grain:
      return "Traçar: um passo é uma linha \u00b7 um raio \u00b7 um pixel";
    case KeyText::modes:
      return "Mover \u00b7 Traçar \u00b7 Ajuda";
    case KeyText::lessons:
      return "as lições";
    case KeyText::bugs:
      return "ache o defeito: a lista \u00b7 uma surpresa \u00b7 é esta linha \u00b7 a cura \u00b7 consertado ou não";
    case KeyText::equation:
      return "a equação viva: os números da linha recém-executada";
    case KeyText::tabs:
      return "imagem 3-D \u00b7 árvore de raios \u00b7 pilha \u00b7 legenda";
    case KeyText::cost:
      return "Custo \u00b7 seus botões \u00b7 tentar \u00b7 tentar uma escada \u00b7 esquecer";
    case KeyText::cost_views:
      return "Custo: próxima como A \u00b7 como B \u00b7 divisão ou diferença \u00b7 contra o quê \u00b7 a divisão à "
             "esquerda \u00b7 à direita";
    case KeyText::cost_effects:
      return "Custo: o que cada efeito acrescenta, ou as tentativas";
    case KeyText::microscope:
      return "Microscópio \u00b7 ampliar \u00b7 menos \u00b7 até os floats \u00b7 a cena inteira";
    case KeyText::numerics:
      return "aritmética ingênua \u00b7 robusta \u00b7 float \u00b7 double";
    case KeyText::structure:
      return "Estrutura: BVH, grade, octree e kd-tree, passo a passo \u00b7 o próximo tipo \u00b7 como se constrói";
    case KeyText::structure_steps:
      return "Estrutura: próxima caixa \u00b7 anterior \u00b7 ao fim \u00b7 ao início";
    case KeyText::exchange:
      return "a planta e o painel trocam de lugar";
    case KeyText::zoom:
      return "enquadrar a cena inteira \u00b7 aproximar \u00b7 afastar";
    case KeyText::lines:
      return "linhas no espaço, e a planta \u00b7 de um pixel da imagem de volta a SCREEN";
    case KeyText::ghosts:
      return "os raios que a profundidade e o limiar cortam";
    case KeyText::tweens:
      return "raios que crescem ao ser formados, ou aparecem de uma vez";
    case KeyText::predict:
      return "prever cada raio antes de vê-lo \u00b7 salvar as previsões";
    case KeyText::turn:
      return "a imagem 3-D ou as linhas: girar à esquerda \u00b7 à direita \u00b7 para cima \u00b7 para baixo";
    case KeyText::shift:
      return "o mesmo: mover à esquerda \u00b7 à direita \u00b7 para cima \u00b7 para baixo";
    case KeyText::approach:
      return "o mesmo: mais perto \u00b7 mais longe \u00b7 como no início";
    case KeyText::image:
      return "imagem 3-D: sua câmera para a cena \u00b7 ajustes \u00b7 mapas de calor";
    case KeyText::add:
      return "Mover: adicionar uma esfera sólida \u00b7 uma esfera transparente \u00b7 um polígono \u00b7 uma luz";
    case KeyText::select:
      return "Mover: selecionar o próximo \u00b7 o anterior";
    case KeyText::edit:
      return "Mover: digitar os seus números \u00b7 remover";
    case KeyText::undo:
      return "desfazer \u00b7 refazer";
    case KeyText::files:
      return "nova \u00b7 abrir \u00b7 salvar \u00b7 salvar como \u00b7 exportar \u00b7 sair";
    case KeyText::theme:
      return "tema escuro ou o do projetor";
    case KeyText::language:
      return "inglês ou português";
    case KeyText::scale:
      return "letras maiores \u00b7 menores \u00b7 como no início";
    case KeyText::menus:
      return "os menus \u00b7 a tela cheia";
    case KeyText::arrows:
      return "Mover: deslocar o que está selecionado; com Shift em passos maiores";
    case KeyText::while_dragging:
      return "ao longo de um eixo, medidas e ângulos redondos \u00b7 na grade";
    case KeyText::wheel:
      return "zoom; arraste a planta vazia para deslocá-la";
    case KeyText::mouse:
      return "girar \u00b7 mover \u00b7 percorrer os raios desse pixel";
    case KeyText::escape:
      return "desfaz um arraste, fecha o que está aberto, encerra AUTO";
    case KeyText::name_while_dragging:
      return "Shift \u00b7 Ctrl, ao arrastar";
    case KeyText::name_wheel:
      return "roda do mouse";
    case KeyText::name_mouse:
      return "3-D: arrastar \u00b7 Shift ou botão direito \u00b7 clique";
  }
  return {};
}

}  // namespace raywalk
