// The text of help mode in Portuguese.

#include "view/text.h"

namespace raywalk {

namespace {

HelpSection numbers() {
  HelpSection section{"Materiais, luzes e limites", {}};
  for (const Explanation& e : portuguese_explanations())
    section.entries.push_back({std::string(portuguese(e.property)), std::string(e.text)});
  return section;
}

}  // namespace

std::vector<HelpSection> portuguese_help() {
  return {
      {"O que é isto",
       {{"",
         "Um traçador de raios acha a cor de um pixel perguntando que luz volta ao longo de um raio que parte do olho. "
         "Aqui ele trabalha numa planta, vista de cima, e executa uma linha por vez. Cada raio é desenhado quando a "
         "sua "
         "linha o forma. O mesmo programa desenha a imagem 3-D: a coluna de pixels é a linha do meio dessa imagem."}}},
      {"O que há na planta",
       {{"EYE", "Onde começam todos os raios primários."},
        {"SCREEN",
         "Uma coluna de pixels diante de EYE. Um raio passa pelo meio de cada um; um pixel se enche com a sua cor "
         "final "
         "quando ela é conhecida."},
        {"Esfera sólida", "Espelha uma parte do que a cerca e não deixa passar nada."},
        {"Esfera transparente", "Vidro: um raio se espelha, outro se dobra e continua lá dentro."},
        {"Polígono", "Um bloco de lados retos. Os seus vértices podem ser movidos, criados e removidos."},
        {"Fonte de luz", "Um raio de sombra até ela diz se a sua luz chega a um ponto."}}},
      {"Modos",
       {{"Mover",
         "Arrume a cena. Arraste os corpos para movê-los, e os pequenos círculos para mudar raio, vértices, rotação, a "
         "direção da vista, e o comprimento e a distância de SCREEN. Tudo pode ser desfeito. Os raios ficam de fora "
         "para não atrapalhar."},
        {"Traçar",
         "Percorra o algoritmo. A linha destacada acaba de ser executada; a contornada é a próxima. Clique num pixel "
         "ou num "
         "raio para ir ao passo em que ele começou."},
        {"Ajuda", "Esta página."}}},
      {"Botões",
       {{"STEP",
         "Executa uma linha e desenha o raio que ela forma. Com \"um raio\" ou \"um pixel\" escolhido, vai até o "
         "próximo raio ou até o fim do pixel."},
        {"VOLTAR", "Desfaz o último passo. STEP e VOLTAR ficam cada vez mais rápidos enquanto são mantidos apertados."},
        {"AUTO", "Dá passos sozinho na velocidade escolhida, até PAUSAR ou até o último pixel."},
        {"CLEAR", "Apaga raios e pixels e recomeça com a primeira linha."},
        {"A barra",
         "Arraste ao longo dela para ver qualquer momento do percurso. Um clique nos números ao lado vai a um passo."},
        {"Por cima, para fora",
         "O menu Percurso passa por cima da SHADE que uma linha chama, e sai daquela que está em curso."},
        {"Prever",
         "Ctrl+P. Antes de cada raio, arraste uma seta para onde ele vai, ou clique no que ele encontra; STEP mostra o "
         "erro. AUTO para onde uma seta é pedida."},
        {"Estrutura",
         "Ctrl+T. Como um raio é procurado numa BVH, grade, octree ou kd-tree: caixa por caixa, com o que foi pulado e "
         "por quê, e quantos testes isso poupa; a outra página mostra como cada uma é construída."},
        {"Paradas",
         "Um clique à esquerda de uma linha do código faz o percurso parar antes dela; o menu Percurso tem outros "
         "lugares onde parar: um DEPTH, um pixel, o encontro com um objeto, a reflexão interna total."}}},
      {"Lições",
       {{"",
         "F2 as abre. Cada passo mostra um lugar do percurso e pergunta o que vem depois: escolha com clique ou número "
         "do teclado, digite um valor, ou arraste uma seta a partir do anel na planta. Revelar mostra a resposta "
         "verdadeira ao lado da sua. Uma lição se abre quando a anterior está concluída; Liberar todas é para "
         "professores, como Apresentador, que acrescenta o roteiro e as notas."}}},
      {"Ache o defeito",
       {{"",
         "Shift+F2 abre uma lista de traçadores, cada um com um defeito. Olhe a imagem, avance passo a passo, e clique "
         "no código a linha com defeito, ou execute-a e tecle Enter; outro Enter diz se é ela. Então os raios "
         "certos ficam ao lado dos errados, pontilhados, e Alt+Enter conserta o defeito e o traz de volta. A sua cena "
         "espera e volta como estava."}}},
      {"Painéis",
       {{"Código",
         "MAIN ALGORITHM e SHADE. DEPTH conta quantas SHADEs estão abertas. Clique numa linha para ir até que ela "
         "tenha corrido de novo."},
        {"Imagem 3-D",
         "A mesma cena como imagem. A linha marcada é SCREEN; o pixel marcado está sendo traçado. Clique em qualquer "
         "pixel para percorrer os seus raios. Arraste para girar a imagem, com Shift ou o botão direito para movê-la, "
         "gire a roda para chegar mais perto; O volta, U põe ali a câmera da cena. Ajustes: como ela é feita, e mapas "
         "de calor do que cada pixel custa e do seu ruído."},
        {"Linhas no espaço",
         "No lugar da planta, para pixels fora de SCREEN e para cenas que não são planas: os contornos de todos os "
         "corpos, a pirâmide que EYE vê, e os raios. Gire-as como a imagem; V troca com a planta, S volta a SCREEN."},
        {"Árvore",
         "Todos os raios do pixel: cada um fica abaixo do raio em cujo encontro se formou. Aponte um para vê-lo na "
         "planta e no código; clique para ir até ele."},
        {"Equação",
         "O que a linha recém-executada calculou, com os números deste raio: que raiz foi tomada, os ângulos da "
         "lei "
         "de Snell, cada termo da soma com a sua cor."},
        {"Microscópio",
         "O encontro do raio em mãos, da cena inteira até os números isolados do computador: a superfície verdadeira, "
         "os pontos que as aritméticas ingênua e robusta acham, e de onde cada uma deixa partir os próximos raios. "
         "Robusta e Ingênua escolhem com que a cena é traçada, Double e Float quantos dígitos há. Tente a ingênua com "
         "épsilon 0 em float, e olhe também a imagem."},
        {"Pilha", "As SHADEs que esperam que outras terminem, a mais interna em cima."},
        {"Legenda", "O que cores, traços e sinais significam."},
        {"Custo",
         "Tentar traça a imagem com os botões como estão; cada tentativa é uma marca num gráfico de erro contra custo. "
         "A página Efeitos mede o que cada efeito acrescenta à cena, e o que todos custariam de qualquer modo."}}},
      numbers(),
      {"Por que raios acabam",
       {{"encontrou", "Achou um objeto; esse ponto é sombreado."},
        {"saiu da cena", "Não encontrou nada e traz o fundo."},
        {"bloqueado", "Um raio de sombra encontrou algo antes da luz: uma cruz marca onde."},
        {"chegou à luz", "Um raio de sombra não encontrou nada antes dela."},
        {"limite de profundidade",
         "SHADE não pode chamar a si mesma mais fundo que isto, e o raio não se formou; um toco com uma barra mostra "
         "para onde ele iria. N mostra o resto dele, pontilhado, e o que teria trazido."},
        {"parte pequena demais", "Poderia mudar o pixel em menos que o limiar; por isso não se formou."},
        {"reflexão interna total",
         "A luz dentro do vidro encontra a superfície num ângulo tão rasante que nada sai: não existe raio refratado, "
         "e "
         "tudo se espelha."},
        {"de costas para a luz",
         "A luz está atrás da superfície e não a alcança; por isso nenhum raio de sombra se forma."}}},
  };
}

}  // namespace raywalk
